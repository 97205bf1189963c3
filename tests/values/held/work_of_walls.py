# SPDX-License-Identifier: LGPL-2.1-or-later
"""
In steps without inertia a wall meets a block and leaves it again, another one slides under it to and fro. The work of walls
is that of the path, though forces begin, end and change their direction within steps: kinetic and stored energy, less
that work, never rise (they rose by 3e-3 of the largest energy).
"""
import numpy

RUNS = [("Walls/bottom/Friction=0.2",), ("Walls/bottom/Friction=1",)]


def measure(start):
    found = {}
    for words in RUNS:
        run = start("work_of_walls.prm", *words)
        kinetic, elastic, work = (run.history[name + "_J_per_m"] for name in ("kinetic_energy", "elastic_energy", "external_work"))
        total = numpy.asarray(kinetic) + numpy.asarray(elastic) - numpy.asarray(work)
        rise = float((total - numpy.minimum.accumulate(total)).max())
        found[words[0]] = {"code": run.code, "says": run.error, "rise": rise / max(elastic),
                           "balance": run.summary["energy_balance_error"]}
    return found


def is_right(found):
    return all(run["code"] == 0 and run["rise"] < 5e-4 and run["balance"] < 5e-4 for run in found.values())
