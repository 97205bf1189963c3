# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What moves, met by rays. A rough disk between plates does its mirror image, and what the plates give it is in its energies to 1e-3.
A disk that is thrown in a ring pushes it along.
"""
from images import Image, differences

RAYS = "Contact/Geometry=rays"


def measure(start):
    runs = []

    def by_rays(scene, *settings, **words):
        runs.append(start(scene, *settings, RAYS, **words))
        return runs[-1]

    found = {"images": differences(by_rays, Image(((-1, 0), (0, 1))), ("disk",), (0.5,))}
    history = runs[0].history
    kinetic, stored, lost, work = (history[f"{name}_J_per_m"][-1]
                                   for name in ("kinetic_energy", "elastic_energy", "dissipated_energy", "external_work"))
    found["missing"] = (kinetic + stored + lost) / work - 1
    ring = by_rays("disk_thrown_in_ring.prm", "Stop/End time=0.016", "Contact/Friction=0.5", codes=(0,))
    bodies = ring.states[-1].bodies
    found["ring"] = {"apart": bodies.center_m[1, 0] - bodies.center_m[0, 0], "speed": bodies.velocity_m_per_s[0, 0]}
    return found


def is_right(found):
    apart, force = found["images"]["disk, friction 0.5"]
    return (apart < 1e-9 and force < 1e-7 and abs(found["missing"]) < 1e-3
            and found["ring"]["apart"] < 4.2e-3 and found["ring"]["speed"] > 0.01)
