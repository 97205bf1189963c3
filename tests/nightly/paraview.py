# SPDX-License-Identifier: LGPL-2.1-or-later
"""
ParaView opens fields.pvd: all times, the four parts, stresses as tensors from which it works out the von Mises stress that
the file has, and it draws a picture. Arguments: PROGRAM SCENE WORK [PARAVIEW]

PARAVIEW is a folder into which Debian's ParaView was unpacked (contrib/paraview_beside.sh), for it cannot be installed beside
python3-vtk9; without it pvbatch is looked for in PATH. Without ParaView the test ends with status 77.
"""

import glob
import json
import os
import shutil
import subprocess
import sys

WITHIN = """
import json, sys
from paraview.simple import *
from paraview import servermanager

reader = PVDReader(FileName=sys.argv[1])
times = list(reader.TimestepValues)
reader.UpdatePipeline(times[-1])
blocks = servermanager.Fetch(reader)
points = ExtractBlock(Input=reader, Selectors=["/Root/points"])
xx, yy, zz, xy = (f"stress_Pa_{c}" for c in ("XX", "YY", "ZZ", "XY"))
calculator = Calculator(Input=points, ResultArrayName="theirs",
                        Function=f"sqrt(0.5*(({xx}-{yy})^2 + ({yy}-{zz})^2 + ({zz}-{xx})^2) + 3*{xy}^2)")
calculator.UpdatePipeline(times[-1])
data = servermanager.Fetch(calculator)
while not hasattr(data, "GetPointData"):
    data = data.GetBlock(0)
data = data.GetPointData()
ours, theirs, stress = (data.GetArray(name) for name in ("von_mises_Pa", "theirs", "stress_Pa"))
n = ours.GetNumberOfTuples()
largest = max(ours.GetValue(i) for i in range(n))
error = max(abs(ours.GetValue(i) - theirs.GetValue(i)) for i in range(n))
view = CreateView("RenderView")
view.ViewSize = [500, 500]
view.ViewTime = times[-1]
shown = Show(points, view)
ColorBy(shown, ("POINTS", "von_mises_Pa"))
shown.PointSize = 4
ResetCamera(view)
SaveScreenshot(sys.argv[2], view)
print("ANSWER " + json.dumps({"times": times, "blocks": blocks.GetNumberOfBlocks(), "components": stress.GetNumberOfComponents(),
                             "points": n, "largest": largest, "error": error}))
"""


def find_paraview(folder):
    """(words that start pvbatch, environment), None without ParaView."""
    environment = dict(os.environ, LIBGL_ALWAYS_SOFTWARE="1")
    program = shutil.which("pvbatch")
    if folder:
        program = os.path.join(folder, "usr/bin/pvbatch")
        libraries = [*glob.glob(os.path.join(folder, "usr/lib/*-linux-gnu")), os.path.join(folder, "usr/lib")]
        environment["LD_LIBRARY_PATH"] = ":".join(libraries)
        environment["PYTHONPATH"] = os.path.join(folder, "usr/lib/python3/dist-packages")
    if not program or not os.path.exists(program):
        return None
    display = [] if os.environ.get("DISPLAY") else ["xvfb-run", "-a", "-s", "-screen 0 800x800x24"]
    if display and not shutil.which("xvfb-run"):
        return None
    return [*display, program, "--force-offscreen-rendering"], environment


def main():
    program, scene, work = map(os.path.abspath, sys.argv[1:4])
    found = find_paraview(sys.argv[4] if len(sys.argv) > 4 else "")
    if found is None:
        print("no ParaView (pvbatch) or no X server (xvfb-run) is there: contrib/paraview_beside.sh unpacks Debian's")
        sys.exit(77)
    words, environment = found
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    os.chdir(work)
    subprocess.run([program, "run", scene, "--output", "out", "--threads", "1"], check=True, capture_output=True)
    with open("within.py", "w", encoding="utf-8") as file:
        file.write(WITHIN)
    for _ in range(4):
        done = subprocess.run([*words, "within.py", os.path.abspath("out/fields.pvd"), "picture.png"], env=environment, text=True,
                              capture_output=True, check=False, timeout=300)
        if "bad X server connection" not in done.stderr:  # xvfb-run starts pvbatch before its server listens, now and then
            break
    answers = [line for line in done.stdout.splitlines() if line.startswith("ANSWER ")]
    assert done.returncode == 0 and answers, done.stdout + done.stderr
    answer = json.loads(answers[0].removeprefix("ANSWER "))
    with open("out/fields.pvd", encoding="utf-8") as file:
        times = sorted({float(line.split('timestep="')[1].split('"')[0]) for line in file if "timestep" in line})
    assert answer["times"] == times, answer
    assert (answer["blocks"], answer["components"]) == (4, 9), answer
    assert "mismatching" not in done.stdout + done.stderr, done.stderr  # arrays of one name, but not of one width
    assert answer["largest"] > 1e3 and answer["error"] < 1e-5 * answer["largest"], answer
    import matplotlib.image
    picture = matplotlib.image.imread("picture.png")[..., :3]
    assert (picture.max(axis=2) - picture.min(axis=2)).max() > 0.3, "the picture has no colour"
    print(f"ParaView read {len(times)} times and {answer['points']} points; von Mises within {answer['error']:.1e} Pa")


main()
