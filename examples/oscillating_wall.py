# SPDX-License-Identifier: LGPL-2.1-or-later
# A viscoelastic block between plates, of which one swings: the loss of a cycle over the frequency, and what Maxwell's law says.
# In the root folder of softgrain: PYTHONPATH=python python3 examples/oscillating_wall.py
import matplotlib.pyplot as plt
import numpy as np
import softgrain

SIDE = 10e-3  # of the block [m]
SHARE, TIME = 0.5, 0.1  # share of the modulus that relaxes, and its relaxation time [s]


def block(frequency, cycles=4, strain=1e-3):
    """The upper plate swings by so much of the side of the block, in the end about five times as much: it never leaves the block."""
    scene = softgrain.Scene()
    scene.title = f"A viscoelastic block; the upper plate swings at {frequency:g} Hz."
    scene.materials.add("gel", law="maxwell", density=1000, youngs_modulus=1e6, poissons_ratio=0.3, shares=SHARE, relaxation_times=TIME)
    scene.bodies.add("block", shape="rectangle", center=(0, SIDE / 2), size=(SIDE, SIDE))
    scene.mesh(lower=(-SIDE, -SIDE / 4), upper=(SIDE, 5 * SIDE / 4), cell_size=SIDE / 4)
    scene.walls.add("bottom", point=(0, 0))
    scene.walls.add("top", point=(0, SIDE), normal=(0, -1), drive="position",
                    position=f"{strain * SIDE:g}*(5*min({frequency:g}*t, 1) + sin(2*pi*{frequency:g}*t))")
    scene.time(scheme="quasi_static", time_step=1 / (100 * frequency))
    scene.stop.end_time = cycles / frequency
    return scene


def loss(run, frequency):
    """Tangent of the angle by which the force is ahead of the way, from the last cycle."""
    history = run.history_table
    last = history.time > history.time[-1] - 1 / frequency
    phase = 2 * np.pi * frequency * history.time[last]
    parts = np.column_stack([np.sin(phase), np.cos(phase), np.ones_like(phase), np.exp(-history.time[last] / TIME)])  # what is left of the start
    in_phase, ahead, _, _ = np.linalg.lstsq(parts, history.top_force[last], rcond=None)[0]
    return ahead / in_phase


def expected(frequency):
    """The same of Maxwell's law, E(ω) = E (1 - g + g iωτ / (1 + iωτ))."""
    way = 2j * np.pi * np.asarray(frequency) * TIME
    modulus = 1 - SHARE + SHARE * way / (1 + way)
    return modulus.imag / modulus.real


def draw(runs):
    figure, axes = plt.subplots(figsize=(4.5, 3.2), layout="constrained")
    frequencies = np.geomspace(min(runs), max(runs))
    axes.semilogx(frequencies, expected(frequencies), label="Maxwell's law")
    axes.semilogx(list(runs), [loss(run, frequency) for frequency, run in runs.items()], "o", label="softgrain")
    axes.set(xlabel="frequency [Hz]", ylabel="tan δ", ylim=(0, None))
    axes.legend()
    return figure


if __name__ == "__main__":
    runs = {frequency: block(frequency).run(f"output/swing_{frequency:g}", again=False) for frequency in (0.3, 1, 3, 10, 30)}
    draw(runs).savefig("output/oscillating_wall.png", dpi=200)
