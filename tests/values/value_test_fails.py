# SPDX-License-Identifier: LGPL-2.1-or-later
"""An owed value passes only when it is wrong in the way that is known: value_test_fails.py FOLDER, with a program that is none."""
import pathlib
import shutil
import sys

import value_test

WORK = pathlib.Path(sys.argv[1])
CASE = '''"""The number is 1, by definition."""
def measure(start):
    return start("{scene}").code
def is_right(code):
    return code == 0
def is_known(code):
    return code == 1
'''
PROGRAM = "#!/bin/sh\n[ {code} = 0 ] || echo '{line}' >&2\n[ {code} = 9 ] && kill -9 $$\nexit {code}\n"
ONE_LINE = "softgrain: error: no step succeeds"

# Where the case lies, exit code of the program, its line, the scene, and what is said of it; "": it passes.
SAMPLES = [
    ("owed", 1, ONE_LINE, "here.prm", ""),
    ("held", 0, "", "here.prm", ""),
    ("owed", 0, "", "here.prm", "the right value has appeared"),
    ("held", 1, ONE_LINE, "here.prm", "not right"),
    ("owed", 2, ONE_LINE, "here.prm", "exit code 2"),
    ("owed", 9, ONE_LINE, "here.prm", "exit code -9"),
    ("owed", 1, "Segmentation fault", "here.prm", "not one clear line"),
    ("owed", 1, ONE_LINE, "missing.prm", "there is no scene"),
    ("elsewhere", 0, "", "here.prm", "neither in"),
]


def said_of(folder, code, line, scene):
    path, program = WORK / folder / "case.py", WORK / "program"
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(CASE.format(scene=scene))
    program.write_text(PROGRAM.format(code=code, line=line))
    program.chmod(0o755)
    try:
        value_test.judge(path, program, WORK / "run")
    except value_test.Wrong as wrong:
        return str(wrong)
    return ""


def main():
    shutil.rmtree(WORK, ignore_errors=True)
    value_test.SCENES = WORK / "scenes"
    value_test.SCENES.mkdir(parents=True)
    (value_test.SCENES / "here.prm").write_text("")
    failed = False
    for *sample, expected in SAMPLES:
        said = said_of(*sample)
        good = expected in said if expected else not said
        print("good" if good else "WRONG", sample, said)
        failed |= not good
    # Wrong in another way: the run ends with a code that the case can judge, and its number is another one.
    path = WORK / "owed/case.py"
    path.write_text(CASE.format(scene="here.prm").replace("return code == 1", "return code == 7"))
    (WORK / "program").write_text(PROGRAM.format(code=1, line=ONE_LINE))
    try:
        value_test.judge(path, WORK / "program", WORK / "run")
        failed = True
    except value_test.Wrong as wrong:
        failed |= "not in the way that is known" not in str(wrong)
    sys.exit(failed)


main()
