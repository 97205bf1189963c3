# SPDX-License-Identifier: LGPL-2.1-or-later
# Soft viscoelastic disks on a floor that shakes: how high they jump, by how much of their modulus relaxes.
# In the root folder of softgrain: PYTHONPATH=python python3 examples/shaken_box.py
import matplotlib.pyplot as plt
import numpy as np
import softgrain

RADIUS = 5e-3  # [m]
AMPLITUDE, FREQUENCY, TIME = 2e-3, 15, 5e-3  # of the floor [m, Hz]; relaxation time [s]


def box(share, number=12, end=0.6, seed=1):
    """Rows of disks above a floor that swings with 1.8 times the acceleration of gravity; so much of their modulus relaxes."""
    columns, step = 4, 2.1 * RADIUS
    row, column = np.divmod(np.arange(number), columns)
    radius = RADIUS * np.random.default_rng(seed).uniform(0.85, 1, number)
    width = (columns + 0.5) * step

    scene = softgrain.Scene()
    scene.title = f"{number} disks on a floor that shakes; {share:g} of their modulus relaxes in {1e3 * TIME:g} ms."
    scene.materials.add("gel", law="maxwell", density=1000, youngs_modulus=1e5, poissons_ratio=0.4, shares=share, relaxation_times=TIME)
    scene.place((column + 0.5 + 0.5 * (row % 2)) * step, (row + 0.6) * step, radius)
    scene.mesh(lower=(-2 * RADIUS, -2 * RADIUS), upper=(width + 2 * RADIUS, 20 * RADIUS), cell_size=RADIUS / 3)
    scene.walls.add("bottom", point=(0, 0), drive="position", position=f"{AMPLITUDE:g}*sin(2*pi*{FREQUENCY:g}*t)")
    scene.walls.add("left", point=(0, 0))
    scene.walls.add("right", point=(width, 0))
    scene.contact.friction = 0.2
    scene.loads.gravity = (0, -9.81)
    scene.time.time_step = 5e-4
    scene.stop.end_time = end
    scene.output(snapshots_every=0.005, points_in_snapshots=False)
    return scene


def heights(run):
    """Times [s], and how high the centre of mass of all disks is above its lowest place [m]."""
    height = np.array([np.average(state.bodies.center_m[:, 1], weights=state.bodies.mass_kg_per_m) for state in run])
    return run.times, height - height.min()


def draw(runs):
    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    for share, run in runs.items():
        times, height = heights(run)
        axes.plot(times, 1e3 * height, label=f"{share:g}")
    axes.set(xlabel="time [s]", ylabel="height of the centre of mass [mm]", ylim=(0, None))
    axes.legend(title="share of the modulus that relaxes", loc="lower center", bbox_to_anchor=(0.5, 1), ncol=len(runs))
    return figure


if __name__ == "__main__":
    runs = {share: box(share).run(f"output/shaken_{share:g}", again=False) for share in (0.05, 0.5, 0.9)}
    draw(runs).savefig("output/shaken_box.png", dpi=200)
