# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A pentagon falls on a straight plate, of one piece and of eight: rays stand in the same places, so all goes the same way. (They
stood elsewhere, and the pentagon was 5e-3 cells away after one hit.)
"""
CELL = 1e-3
ENDS = (-1.9e-3, -4.5e-3), (2.2e-3, -4.5e-3)


def points(pieces):
    (x, y), (end, _) = ENDS
    return "; ".join(f"{x + (end - x) * k / pieces!r}, {y!r}" for k in range(pieces + 1))


def measure(start):
    found = {}
    for scheme in ("explicit", "moreau_jean"):
        runs = [start("pentagon_on_a_plate.prm", f"Time/Scheme={scheme}", f"Obstacles/plate/Points={points(n)}") for n in (1, 8)]
        one, other = (run.states[-1].bodies.center_m[0] for run in runs)
        loss = runs[0].history["contact_loss_J_per_m"][-1]
        found[scheme] = {"code": max(run.code for run in runs), "apart": max(abs(one - other)) / CELL, "rubbed": loss}
    return found


def is_right(found):
    return all(run["code"] == 0 and run["apart"] < 1e-9 and run["rubbed"] > 0 for run in found.values())
