# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk between two rough plates at 20 degrees to each side, which come nearer. What each plate gives it stands across its way out,
so it slips out when the friction is below tan 20 degrees = 0.36397, and is pressed when it is above.
"""

RAYS = ("Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6")


def measure(start):
    found = {}
    for friction in (0.3635, 0.3645):
        run = start("nipped_disk.prm", *RAYS, f"Walls/below/Friction={friction}", f"Walls/above/Friction={friction}", codes=(0,))
        below, above = (run.history[f"{name}_force_N_per_m"][-1] for name in ("below", "above"))
        found[friction] = {"force": below, "same": abs(above / below - 1)}
    return found


def is_right(found):
    # 5e-4 of Young's modulus times the radius is a light contact, a hundredth of it none.
    return (found[0.3635]["force"] < 5e-3 * 1e6 * 5e-3 * 0.1 and found[0.3645]["force"] > 0.04 * 1e6 * 5e-3
            and all(one["same"] < 1e-6 for one in found.values()))
