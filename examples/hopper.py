# SPDX-License-Identifier: LGPL-2.1-or-later
# Soft disks, read from a table, flow out of a hopper, with openings of different widths: the discharge over time.
# In the root folder of softgrain: PYTHONPATH=python python3 examples/hopper.py
import os

import matplotlib.pyplot as plt
import numpy as np
import softgrain

DIAMETER = 10e-3  # of the largest disk [m]
GRAINS = os.path.join(os.path.dirname(__file__), "hopper_grains.csv")  # x_m, y_m, radius_m of each


def hopper(opening, number=30, end=0.5):
    """Two plates with an opening of so many diameters; above them the lowest disks of the table."""
    grains = softgrain.read_table(GRAINS)
    lowest = np.argsort(grains.y_m)[:number]
    half, top = 40e-3, 45e-3
    scene = softgrain.Scene()
    scene.title = f"{number} soft disks fall out of a hopper with an opening of {opening:g} diameters."
    scene.materials.add("gel", law="neo_hookean", density=1000, youngs_modulus=2e4, poissons_ratio=0.4)
    scene.place(grains.x_m[lowest], grains.y_m[lowest], grains.radius_m[lowest])
    scene.mesh(lower=(-half - 4e-3, -40e-3), upper=(half + 4e-3, top + 50e-3), cell_size=DIAMETER / 5)
    scene.walls(bottom={"point": (0, -36e-3)}, left={"point": (-half, 0)}, right={"point": (half, 0)})
    for side, name in ((-1, "left_plate"), (1, "right_plate")):
        line = [(side * half, top), (side * 0.5 * opening * DIAMETER, 10e-3)]
        scene.obstacles.add(name, points=line if side < 0 else line[::-1], friction=0.2)
    scene.contact.friction = 0.2
    scene.loads.gravity = (0, -9.81)
    scene.time.time_step = 1e-3
    scene.stop.end_time = end
    scene.output(snapshots_every=0.02, fields_every=0.02)
    return scene


def fallen(run, below=10e-3):
    """Times, and how many disks are below the opening."""
    return run.times, np.array([np.sum(state.bodies.center[:, 1] < below) for state in run])


def draw(runs):
    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    for opening, run in runs.items():
        axes.step(*fallen(run), label=f"{opening:g} diameters")
    axes.set(xlabel="time [s]", ylabel="disks below the opening")
    axes.legend(title="opening")
    return figure


if __name__ == "__main__":
    runs = {opening: hopper(opening).run(f"output/hopper_{opening:g}", again=False) for opening in (1.5, 2, 3)}
    draw(runs).savefig("output/hopper.png", dpi=200)
    runs[2].at(0.2).plot("pressure_Pa").savefig("output/hopper_2.png", dpi=200)
