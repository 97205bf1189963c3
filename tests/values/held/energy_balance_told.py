# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Contact gives no energy with newmark, however long its steps are: it is not part of the stored acceleration. A run whose energy balance misses
more than 2 % says so at its end: here one that lays its grid anew in every step
and takes all velocities from it, which loses a twentieth.
"""


def look(run):
    log = (run.folder / "run.log").read_text()
    return {"error": run.summary["energy_balance_error"], "told": "warning: energy came from nothing" in log}


def measure(start):
    scene = "newmark_impact.prm"
    return {"newmark": look(start(scene)), "short": look(start(scene, "Time/Time step=1e-4")),
            "moreau_jean": look(start(scene, "Time/Scheme=moreau_jean")),
            "new grids": look(start(scene, "Material points/Grid update=every step", "Material points/Transfer=flip",
                                    "Material points/PIC fraction=1"))}


def is_right(found):
    return (all(run["told"] == (run["error"] > 0.02) for run in found.values()) and found["new grids"]["told"]
            and all(found[name]["error"] < 1e-3 for name in ("newmark", "short", "moreau_jean")))
