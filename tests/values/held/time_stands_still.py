# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A scene that cannot go on: bodies grow between walls that stay, and steps become shorter and shorter. The run ends while steps
still move the time, with one line that names a body and its place, and the state is saved.
"""


def measure(start):
    run = start("steps_to_nothing.prm")
    history = run.history
    return {"code": run.code, "says": run.error, "shortest_step_s": min(history["dt_s"][1:]),
            "saved": len(list(run.folder.glob("state-*.h5"))), "time_s": history["time_s"][-1]}


def is_right(found):
    return (found["code"] == 1 and "body '" in found["says"] and ") m" in found["says"] and found["saved"] == 1
            and found["shortest_step_s"] > 1e-12)
