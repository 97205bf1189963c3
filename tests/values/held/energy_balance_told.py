# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A run whose energy balance misses more than 2 % says so at its end. With newmark contact gives energy where steps are long; with an eighth of
the step it is less, and moreau_jean, which gives none, says nothing.
"""


def look(run):
    log = (run.folder / "run.log").read_text()
    return {"error": run.summary["energy_balance_error"], "told": "warning: energy came from nothing" in log}


def measure(start):
    scene = "newmark_gives_energy.prm"
    return {"newmark": look(start(scene)), "short": look(start(scene, "Time/Time step=1e-4")),
            "moreau_jean": look(start(scene, "Time/Scheme=moreau_jean"))}


def is_right(found):
    return (all(run["told"] == (run["error"] > 0.02) for run in found.values()) and found["newmark"]["told"]
            and found["short"]["error"] < 0.25 * found["newmark"]["error"] and not found["moreau_jean"]["told"])
