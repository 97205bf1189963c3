# SPDX-License-Identifier: LGPL-2.1-or-later
# A hundred soft disks of two sizes, with friction, compacted to a packing fraction of 0.95: three mixtures, and how far they differ.
# In the root folder of softgrain: PYTHONPATH=python python3 examples/bidisperse_mixture.py
import matplotlib.pyplot as plt
import numpy as np
import softgrain

SMALL, LARGE = 1e-3, 1.4e-3  # radii [m], as many of the one as of the other


def mixture(seed, number=100, packing_fraction=0.95):
    """A box with a lid that comes down on disks of both sizes, which stand in rows in random order."""
    radius = np.random.default_rng(seed).permutation(np.repeat([SMALL, LARGE], number // 2))
    columns, step = int(np.sqrt(number)), 2.02 * LARGE
    row, column = np.divmod(np.arange(number), columns)
    width, height = (columns + 0.5) * step, (row[-1] + 1) * step

    scene = softgrain.Scene()
    scene.title = f"{number} soft disks of two sizes in random order (seed {seed}), compacted by the upper wall."
    scene.materials.add("gel", law="neo_hookean", density=1000, youngs_modulus=1e6, poissons_ratio=0.45)
    scene.place((column + 0.5 + 0.5 * (row % 2)) * step, (row + 0.5) * step, radius, material="gel")
    scene.mesh(lower=(-LARGE, -LARGE), upper=(width + LARGE, height + LARGE), cell_size=SMALL / 3)
    scene.walls.add("bottom", point=(0, 0))
    scene.walls.add("top", point=(0, height), velocity=1)
    scene.walls.add("left", point=(0, 0))
    scene.walls.add("right", point=(width, 0))
    scene.contact.friction = 0.3
    scene.stop.packing_fraction = packing_fraction
    scene.output.fields_every = 1e-3
    return scene


def draw(runs):
    """Stress on the lid over the packing fraction."""
    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    for run in runs:
        history = run.history_table
        axes.plot(history.packing_fraction, history.top_force / (history.right_position - history.left_position) / 1e3)
    axes.set(xlabel="packing fraction Φ", ylabel="stress on the lid [kPa]")
    return figure


if __name__ == "__main__":
    runs = [mixture(seed).run(f"output/mixture_{seed}", again=False) for seed in (1, 2, 3)]
    draw(runs).savefig("output/mixture.png", dpi=200)
    runs[0][-1].plot("pressure_Pa").savefig("output/mixture_1.png", dpi=200)
