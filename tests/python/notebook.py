# SPDX-License-Identifier: LGPL-2.1-or-later
"""Figure 4.3, as notebook and as script the same fifteen lines: on the scenes of thirty grains both models have their curves."""

import json
import os
import sys

import common
import matplotlib.pyplot as plt

EXAMPLES = os.path.join(common.PYTHON, os.pardir, "examples")
with open(os.path.join(EXAMPLES, "figure_4_3.py"), encoding="utf-8") as file:
    lines = [line for line in file.read().splitlines() if not line.startswith("#")]
with open(os.path.join(EXAMPLES, "figure_4_3.ipynb"), encoding="utf-8") as file:
    book = json.load(file)
cells = ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code"]
if any(cell.get("outputs") for cell in book["cells"]):
    sys.exit("the notebook must be committed without outputs")
if cells[-1].splitlines() != lines:
    sys.exit("notebook and script differ")
if len([line for line in lines if line]) > 15:
    sys.exit("these are more than fifteen lines")
known = {"__name__": "__main__"}
os.makedirs("examples")
os.symlink(os.path.join(EXAMPLES, os.pardir, "parameters"), "parameters")
os.chdir("examples")
for code in cells:
    exec(code.replace("thesis/uniaxial_compaction_", "gallery/thirty_grains_"), known)  # noqa: S102
axes = plt.gcf().axes[0]
texts = [text.get_text() for text in axes.get_legend().get_texts()]
print("\n".join(texts))
points = [line.get_data() for line in axes.lines if line.get_marker() == "o"]
if len(points) != 2 or not all(len(x) > 10 and y[0] >= 0.85 and y[-1] > 0.93 and x[-1] > 2 for x, y in points):
    sys.exit("a curve is missing or does not rise to a packing fraction of 0.93")
if not os.path.exists("figure_4_3.png"):
    sys.exit("there is no picture")
