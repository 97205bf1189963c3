# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Without inertia nothing holds a disk under gravity: no floor, no wall. The run ends within a step and says so, with the body.
"""


def measure(start):
    run = start("nothing_holds.prm")
    return {"code": run.code, "says": run.error, "time_s": run.summary["simulated_time_s"]}


def is_right(found):
    return found["code"] == 1 and "nothing holds body 'b'" in found["says"] and found["time_s"] == 0
