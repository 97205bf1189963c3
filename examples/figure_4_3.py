# SPDX-License-Identifier: LGPL-2.1-or-later
# Figure 4.3 of Nguyen (2016): packing fraction against stress, with the laws (4.5) for MPM and (4.1) for BPM.
# In the root folder of softgrain: PYTHONPATH=python python3 examples/figure_4_3.py
import matplotlib.pyplot as plt
import numpy as np
import softgrain
from softgrain import fits

for model, changes, law, name in (("mpm", {}, lambda s, c: 0.85 + c * (s - 1), "Φ0/β"),
                                  ("bpm", {"Time/Time step": 5e-7}, lambda s, c: 1 - 0.15 * np.exp(-c * (s - 1)), "α")):
    h = softgrain.run(f"parameters/thesis/uniaxial_compaction_{model}.prm", changes, f"output/{model}", again=False).history_table
    packing, stress = fits.means(h.packing_fraction, h.bottom_force / (h.right_position - h.left_position), 0.005)
    ratio, packing = (stress / fits.value_at(packing, stress, 0.85, 0.01))[packing > 0.85], packing[packing > 0.85]
    constant = fits.smallest(lambda c: np.sum((law(ratio, c) - packing)**2), 0, 10)
    points, = plt.plot(ratio, packing, "o", label=f"{model.upper()}, {name} = {constant:.2g}")
    plt.plot(np.sort(ratio), law(np.sort(ratio), constant), ":", color=points.get_color())
plt.gca().set(xlabel="stress over that at Φ = 0.85", ylabel="packing fraction Φ", ylim=(0.84, 1))
plt.legend()
plt.savefig("figure_4_3.png", dpi=200)
