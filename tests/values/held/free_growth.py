# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk that grows freely stores nothing, so growth brings in nothing and nothing is dissipated: with the usual step less than 1e-6
of what the same disk stores when four walls hold it. What is left in longer steps is what resists motion in a step.
"""

BOX = [f"Walls/{name}/{key}={value}" for name, at, normal in (("bottom", "0, -1e-3", "0, 1"), ("top", "0, 1e-3", "0, -1"),
                                                              ("left", "-1e-3, 0", "1, 0"), ("right", "1e-3, 0", "-1, 0"))
       for key, value in (("Point", at), ("Normal", normal))]


def measure(start):
    found = {}
    confined = start("free_growth.prm", "Walls/Names=bottom, top, left, right", *BOX, codes=(0,)).history
    stored = confined["elastic_energy_J_per_m"][-1]
    found["confined_balance"] = (confined["external_work_J_per_m"][-1] - confined["dissipated_energy_J_per_m"][-1]) / stored - 1
    for dt in ("0.1", "0.05"):
        free = start("free_growth.prm", "Time/Time step=" + dt, codes=(0,)).history
        found[dt] = [free[name][-1] / stored for name in ("growth_work_J_per_m", "dissipated_energy_J_per_m")]
    usual = start("free_growth.prm", "Time/Time step=0", "Stop/End time=1e-2", codes=(0,)).history
    found["usual"] = 100 * usual["dissipated_energy_J_per_m"][-1] / stored  # in 1 s
    return found


def is_right(found):
    coarse, fine = found["0.1"], found["0.05"]
    return (max(map(abs, coarse + fine)) < 2e-5 and abs(found["usual"]) < 1e-6 and abs(coarse[0] - coarse[1]) < 1e-7
            and abs(found["confined_balance"]) < 0.02)
