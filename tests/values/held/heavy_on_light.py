# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk on one that is a thousand times lighter, in a shaft, under gravity that grows slowly and then stays: the bottom bears the
weight of both, 9.81 m/s² times 1001 times 0.0785 kg/m = 771.246 N/m (points and cells make 2e-5 of it), and nothing sinks in.
"""


def measure(start):
    run = start("shaft.prm", "Bodies/high/Material=heavy", "Bodies/low/Material=gel", "Materials/Names=gel, heavy",
                "Materials/heavy/Law=neo_hookean", "Materials/heavy/Density=1e6",
                "Materials/heavy/Neo-Hookean/Young's modulus=1e6", "Materials/heavy/Neo-Hookean/Poisson's ratio=0.3", "Stop/End time=1.2",
                *(f"Bodies/{name}/Body force=0; -9.81*min(1,t)" for name in ("low", "high")))
    state = run.states[-1]
    low, high = state.bodies.center_m[:, 1]
    return {"code": run.code, "says": run.error, "apart_m": high - low, "bottom_N_per_m": state.walls.normal_force_N_per_m[0]}


def is_right(found):
    return found["code"] == 0 and found["apart_m"] > 8e-3 and abs(found["bottom_N_per_m"] - 771.246) < 0.02
