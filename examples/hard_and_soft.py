# SPDX-License-Identifier: LGPL-2.1-or-later
# Hard and soft disks, mixed at random, compacted: who bears the load?
# In the root folder of softgrain: PYTHONPATH=python python3 examples/hard_and_soft.py
import matplotlib.pyplot as plt
import numpy as np
import softgrain

RADIUS = 1e-3  # [m]


def mixture(ratio, seed=1, side=8, packing_fraction=0.93):
    """Rows of disks of one size in a box with a lid; every second one, at random, is harder by this ratio of moduli."""
    random, step = np.random.default_rng(seed), 2.1 * RADIUS
    row, column = np.divmod(np.arange(side * side), side)
    x, y = (column + 0.5 + 0.5 * (row % 2)) * step, (row + 0.5) * step
    width, height = (side + 0.5) * step, side * step

    scene = softgrain.Scene()
    scene.title = f"{side * side} disks, half of them {ratio:g} times as hard as the others, compacted by the upper wall."
    for name, modulus in (("soft", 1e6), ("hard", ratio * 1e6)):
        scene.materials.add(name, law="neo_hookean", density=1000, youngs_modulus=modulus, poissons_ratio=0.4)
    scene.place(x, y, RADIUS * random.uniform(0.9, 1, side * side), random.permutation(np.resize(["soft", "hard"], side * side)))
    scene.mesh(lower=(-RADIUS, -RADIUS), upper=(width + RADIUS, height + RADIUS), cell_size=RADIUS / 3)
    scene.walls(bottom={"point": (0, 0)}, top={"point": (0, height), "velocity": 1}, left={"point": (0, 0)}, right={"point": (width, 0)})
    scene.contact(friction=0.2, friction_of_pairs={("hard", "hard"): 0.4})
    scene.stop.packing_fraction = packing_fraction
    scene.output.snapshots_every = 2e-4
    return scene


def shares(run):
    """Packing fraction, and the mean pressure in hard and in soft disks over that in all, where there is one [table]."""
    kinds = softgrain.read_table(f"{run.directory}_grains.csv")["material"]
    rows = []
    for state in run:
        pressure, area = state.bodies.mean_pressure, state.bodies.area
        means = [np.average(pressure[kinds == kind], weights=area[kinds == kind]) for kind in ("hard", "soft")]
        rows.append((run.value_at("packing_fraction", state.time), *means))
    found = np.array(rows)
    return found[:, 0], found[:, 1], found[:, 2]


def draw(runs):
    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    for number, (ratio, run) in enumerate(runs.items()):
        packing, hard, soft = shares(run)
        pressed = soft > 2e3
        axes.plot(packing[pressed], hard[pressed] / soft[pressed], "o-", markersize=3, color=f"C{number}", label=f"{ratio:g}")
    axes.set(xlabel="packing fraction Φ", ylabel="pressure in hard disks over soft ones", ylim=(0, None))
    axes.legend(title="ratio of moduli")
    return figure


if __name__ == "__main__":
    runs = {ratio: mixture(ratio).run(f"output/hard_and_soft_{ratio:g}", again=False) for ratio in (1, 3, 10)}
    draw(runs).savefig("output/hard_and_soft.png", dpi=200)
    runs[10][-1].plot("pressure_Pa").savefig("output/hard_and_soft_10.png", dpi=200)
