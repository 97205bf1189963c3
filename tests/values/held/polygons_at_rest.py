# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Thirty polygons without friction and inertia come to a packing fraction of .95, every state in balance. On the way two corners pass by each other
within a ten thousandth of a cell. Each had a ray that ended where the other body began, so held steps saw one of them at a time and went round
between two states for ever.
"""


def measure(start):
    run = start("../../../parameters/gallery/thirty_grains_quasi_static_mpm.prm", "Packing/Packing fraction=0.7", "Stop/End time=1",
                "Packing/Shapes=polygon", "Packing/Corners=5, 8", "Packing/Seed=8", "Output/Fields every=0", "Output/Snapshots every=0")
    rows = run.history
    energies = [rows[f"{kind}_J_per_m"][-1] for kind in ("kinetic_energy", "elastic_energy", "dissipated_energy")]
    return {"code": run.code, "fraction": rows["packing_fraction"][-1], "unbalanced": max(rows["unbalanced_force"]),
            "missing": 1 - sum(energies) / rows["external_work_J_per_m"][-1]}


def is_right(found):
    return found["code"] == 0 and found["fraction"] > 0.949 and found["unbalanced"] <= 1e-4 and abs(found["missing"]) < 5e-3
