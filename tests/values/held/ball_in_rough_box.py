# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A ball in a box of six rough walls that come nearer at three speeds, with a friction of 1. Sets of rays that are open, stick and slip go
round there where no ray may keep its friction, and steps are cut. The run comes to its end in few passes. Steps of half the length bear the
same within half a per cent, and less than 1 % of the work of the walls is missing.
"""
WALLS = "left", "front", "bottom"


def measure(start):
    runs = [start("ball_in_rough_box.prm", f"Time/Wall way={way}", codes=(0,)).history for way in (0.2, 0.1)]
    last = [{name: column[-1] for name, column in history.items()} for history in runs]
    booked = [row["elastic_energy_J"] + row["dissipated_energy_J"] for row in last]
    return {"forces": max(abs(last[0][f"{wall}_force_N"] / last[1][f"{wall}_force_N"] - 1) for wall in WALLS),
            "missing": [1 - energy / row["external_work_J"] for energy, row in zip(booked, last)],
            "passes": [sum(history["contact_sweeps"]) for history in runs]}


def is_right(found):
    return found["forces"] < 0.005 and all(abs(share) < 0.01 for share in found["missing"]) and max(found["passes"]) < 700
