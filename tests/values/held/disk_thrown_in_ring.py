# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk, and an ellipse, of radius 3 mm fly at 0.5 m/s from the centre of a ring of inner radius 7 mm. They meet the ring after 8 ms
and push it along: after 16 ms the ring moves, and what flew is still within it, whether there is friction or not.
"""

ELLIPSE = ["Bodies/disk/Shape=ellipse", "Bodies/disk/Semi-axes=3e-3, 2e-3", "Bodies/disk/Radius=0"]


def measure(start):
    found = []
    for shape, friction in ([], 0), (ELLIPSE, 0), ([], 0.5):
        run = start("disk_thrown_in_ring.prm", "Stop/End time=0.016", f"Contact/Friction={friction}", *shape)
        bodies = run.states[-1].bodies
        ring, disk = bodies.center_m[:, 0]
        found.append({"code": run.code, "says": run.error, "apart_m": disk - ring, "ring_m_per_s": bodies.velocity_m_per_s[0, 0],
                      "time_s": run.history["time_s"][-1]})
    return found


def is_right(found):
    return all(case["code"] == 0 and case["apart_m"] < 4.2e-3 and case["ring_m_per_s"] > 0.01 for case in found)
