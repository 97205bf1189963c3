# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the driver of the program tests lets pass: the default tolerances, those of a test and those of single columns."""
import pathlib
import subprocess
import sys

CMAKE, NUMDIFF, WORK = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
DRIVER = pathlib.Path(__file__).parents[1] / "run_test.cmake"
PRINTED = "force 1000 N at 2\nforce -500 N at 3\n"
COLUMN = "# tolerance of column 2: 0 1e-2\n"
OTHER = "# tolerance: 0 1e-3\n"
# What is expected of the lines above, and whether they pass.
CASES = [
    (PRINTED, True),
    (PRINTED.replace("1000", "1000.00001"), True),
    (PRINTED.replace("1000", "1000.01"), False),
    (OTHER + PRINTED.replace("1000", "1000.9"), True),
    (OTHER + PRINTED.replace("1000", "1002"), False),
    (COLUMN + PRINTED.replace("1000", "1009"), True),
    (COLUMN + PRINTED.replace("-500", "-504"), True),
    (COLUMN + PRINTED.replace("1000", "1020"), False),
    (COLUMN + PRINTED.replace("at 3", "at 3.01"), False),
    (OTHER + COLUMN + PRINTED.replace("-500", "-504").replace("at 3", "at 3.002"), True),
    (OTHER + COLUMN + PRINTED.replace("-500", "-504").replace("at 3", "at 3.02"), False),
    (COLUMN + PRINTED.replace("force -500", "force"), False),
    ("# tolerance of columns 2: 0 1e-2\n" + PRINTED, False),
]

WORK.mkdir(parents=True, exist_ok=True)
(WORK / "printed").write_text(PRINTED)
wrong = 0
for expected, passes in CASES:
    (WORK / "case.output").write_text(expected)
    done = subprocess.run([CMAKE, "-DPROGRAM=cat", f"-DARGUMENTS={WORK / 'printed'}", f"-DEXPECTED={WORK / 'case.output'}", "-DTHREADS=1",
                           f"-DNUMDIFF={NUMDIFF}", f"-DWORK={WORK / 'run'}", "-P", DRIVER], capture_output=True, text=True, check=False)
    if (done.returncode == 0) != passes:
        wrong += 1
        print(f"{'refused' if passes else 'passed'}:\n{expected}{done.stderr}")
print(f"{len(CASES)} expectations, {wrong} judged wrongly")
sys.exit(1 if wrong else 0)
