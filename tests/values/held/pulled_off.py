# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk that sticks to a plane is pulled off. Its flanks are drawn to the plane, and rays meet them on a slope: what adhesion does there
is no work that contact gives, so no step is refused. It parts at 621 N/m by Baney and Hui; a grid of four hundred microns finds 643.
"""

SCENE = "../../../parameters/verification/pull_off.prm"


def measure(start):
    run = start(SCENE, "Mesh/Cell size=4e-4", "Output/Snapshots every=0", "Output/Fields every=0", codes=(0,))
    force, pulled = run.history["bottom_force_N_per_m"], run.history["adhesion_work_J_per_m"]
    return {"parts at": -min(force), "held at the end": force[-1], "steps": len(force) - 1, "adhesion in the first step": pulled[1],
            "balance": run.summary["energy_balance_error"]}


def is_right(found):
    return (abs(found["parts at"] / 621 - 1) < 0.05 and found["held at the end"] == 0 and found["steps"] <= 150
            and found["adhesion in the first step"] > 0 and found["balance"] < 1e-5)
