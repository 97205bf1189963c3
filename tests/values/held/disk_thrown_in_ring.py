# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk of radius 3 mm flies at 0.5 m/s from the centre of a ring of inner radius 7 mm. It meets the ring after 8 ms and pushes it
along: after 20 ms the ring moves, and the disk is still within it.
"""


def measure(start):
    run = start("disk_thrown_in_ring.prm")
    bodies = run.states[-1].bodies
    ring, disk = bodies.center_m[:, 0]
    return {"code": run.code, "says": run.error, "apart_m": disk - ring, "ring_m_per_s": bodies.velocity_m_per_s[0, 0]}


def is_right(found):
    return found["code"] == 0 and found["apart_m"] < 4.2e-3 and found["ring_m_per_s"] > 0.01
