# SPDX-License-Identifier: LGPL-2.1-or-later
# The force on a disk between two plates, from which one would work out a modulus: how fine must the cells be for two percent?
# In the root folder of softgrain: PYTHONPATH=python python3 examples/modulus.py
import matplotlib.pyplot as plt
import softgrain
from softgrain.study_text import print_findings

RADIUS = 5e-3  # [m]

STUDY = """
set Scene     = modulus.prm
set Reference = cell = {finest}
set Levels    = 0.05, 0.02, 0.01
subsection Knobs
  set Names = cell
  subsection cell
    set Parameter = Mesh/Cell size
    set Values    = {cells}
  end
end
subsection Quantities
  set Names = force
  subsection force
    set Column  = 0.5*(bottom_force + top_force)
    set Against = axial_strain
    set At      = {strains}
    set Norm    = rms
  end
end
"""


def press(strain):
    """A disk, pressed slowly by the upper plate."""
    scene = softgrain.Scene()
    scene.title = "A disk between two plates, without inertia."
    scene.materials.add("gel", law="neo_hookean", youngs_modulus=1e6, poissons_ratio=0.3)
    scene.bodies.add("disk", center=(0, RADIUS), radius=RADIUS)
    scene.mesh(lower=(-1.5 * RADIUS, -0.5 * RADIUS), upper=(1.5 * RADIUS, 2.5 * RADIUS), cell_size=RADIUS / 5)
    scene.walls(bottom={"point": (0, 0)}, top={"point": (0, 2 * RADIUS), "velocity": 1})
    scene.time(scheme="quasi_static", time_step=RADIUS / 250)
    scene.stop.axial_strain = strain
    scene.output.number_of_field_outputs = 0
    return scene


def study(folder, cells=(3, 5, 8, 12), finest=20, strains=(0.05, 0.1, 0.15)):
    """Runs the scene with so many cells in a radius; the findings tell how far the forces are from those with the finest ones."""
    scene = press(1.1 * max(strains))
    scene.write(f"{folder}/modulus.prm")
    with open(f"{folder}/modulus_study.prm", "w", encoding="utf-8") as file:
        file.write(STUDY.format(cells=", ".join(f"{RADIUS / number:.4g}" for number in cells), finest=f"{RADIUS / finest:.4g}",
                                strains=", ".join(map(str, strains))))
    return softgrain.run_study(f"{folder}/modulus_study.prm", f"{folder}/runs")


def draw(findings):
    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    known = [one for one in findings.results if not one.point.is_reference]
    axes.plot([RADIUS / float(one.point.values["cell"]) for one in known], [100 * one.differences["force"].error for one in known], "o-")
    axes.axhline(2, color="#888888", linewidth=0.8)
    axes.set(xlabel="cells in a radius", ylabel="error of the force [%]", ylim=(0, None))
    return figure


if __name__ == "__main__":
    found = study("output/modulus")
    print_findings(found)
    draw(found).savefig("output/modulus.png", dpi=200)
