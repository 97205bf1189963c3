# SPDX-License-Identifier: LGPL-2.1-or-later
"""The notebook of figure 4.3 runs, on the scenes of thirty grains: it draws both models with their laws."""

import json
import os
import sys

import common
import matplotlib.pyplot as plt

SOURCE = os.path.join(common.PYTHON, os.pardir)
with open(os.path.join(SOURCE, "examples", "figure_4_3.ipynb"), encoding="utf-8") as file:
    book = json.load(file)
cells = ["".join(cell["source"]) for cell in book["cells"] if cell["cell_type"] == "code"]
if any(cell.get("outputs") for cell in book["cells"]):
    sys.exit("the notebook must be committed without outputs")
known = {}
os.makedirs("examples")
os.symlink(os.path.join(SOURCE, "parameters"), "parameters")
os.chdir("examples")
for code in cells:
    known = known or {"__name__": "__main__"}
    exec(code.replace("thesis/uniaxial_compaction_", "gallery/thirty_grains_"), known)  # noqa: S102
axes = plt.gcf().axes[0]
texts = [text.get_text() for text in axes.get_legend().get_texts()]
print("\n".join(texts))
points = [line.get_data() for line in axes.lines if line.get_marker() == "o"]
if len(points) != 2 or not all(len(x) > 10 and y[0] >= 0.85 and y[-1] > 0.93 and x[-1] > 2 for x, y in points):
    sys.exit("a curve is missing or does not rise to a packing fraction of 0.93")
