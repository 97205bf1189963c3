# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Without inertia a load acts on a plate above a block. One that is there at once does the work of the load times the way of the plate,
though the block pushes back with nothing at first; the block, nearly linear, stores half of it, and the rest is told as lost. (The mean
of both ends was taken, which in a box of two blocks was less than these store.) One that grows evenly does the work that the block stores.
"""
PRESSURES = {"at once": "1e4", "evenly": "1e5*min(t, 0.1)"}
WIDTH, START = 9e-3, 6.000002e-3


def measure(start):
    found = {}
    for name, pressure in PRESSURES.items():
        run = start("load_of_a_wall.prm", f"Walls/top/Pressure={pressure}")
        way = START - run.history["top_position_m"][-1]
        work, stored = (run.history[column + "_J_per_m"][-1] for column in ("top_work", "elastic_energy"))
        found[name] = {"code": run.code, "says": run.error, "work over load times way": work / (1e4 * WIDTH * way),
                       "stored over work": stored / work, "balance": run.summary["energy_balance_error"]}
    return found


def is_right(found):
    at_once, evenly = found["at once"], found["evenly"]
    return (all(run["code"] == 0 and run["balance"] < 1e-2 for run in found.values())
            and abs(at_once["work over load times way"] - 1) < 1e-6 and abs(at_once["stored over work"] - 0.5) < 0.01
            and abs(evenly["work over load times way"] - 0.5) < 0.01 and abs(evenly["stored over work"] - 1) < 0.01)
