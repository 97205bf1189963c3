# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A C flies with both of its flat ends against a wall and turns, so that they touch one after the other. Mirrored at y = 0 the ends
come the other way round, and it does the mirror image. (The end that was found first took over the rays of the other one.)
Without a turn both ends lie flat on the wall, and a larger mesh changes nothing. (Rounding said where rays of flat sides stand.)
"""
CELL = 1e-3
CORNERS = ((-8, -8.3), (8.3, -8.3), (8.3, -3.4), (-3, -3.4), (-3, 3.4), (8.3, 3.4), (8.3, 8.3), (-8, 8.3))  # mm


def settings(sign):
    corners = CORNERS if sign > 0 else CORNERS[::-1]
    vertices = "; ".join(f"{x * 1e-3!r}, {sign * y * 1e-3!r}" for x, y in corners)
    return f"Bodies/c/Vertices={vertices}", f"Bodies/c/Angular velocity={sign * 15.0!r}"


def in_larger_mesh(start):
    """The largest change of the force on the wall, over the largest force."""
    flat = (*settings(1.), "Bodies/c/Angular velocity=0", "Time/Scheme=explicit", "Time/Time step=1e-5")
    meshes = ("-12e-3, -12e-3", "12e-3, 12e-3"), ("-15e-3, -14e-3", "14e-3, 17e-3")
    one, other = (start("ends_at_a_wall.prm", *flat, f"Mesh/Lower={lower}", f"Mesh/Upper={upper}").history["right_force_N_per_m"]
                  for lower, upper in meshes)
    return max(abs(a - b) for a, b in zip(one, other)) / max(one)


def measure(start):
    runs = [start("ends_at_a_wall.prm", *settings(sign)) for sign in (1., -1.)]
    (x, y), (other_x, other_y) = (run.states[-1].bodies.center_m[0] for run in runs)
    forces = [run.history["right_force_N_per_m"] for run in runs]
    steps = min(map(len, forces))
    return {"code": max(run.code for run in runs), "says": [run.error for run in runs],
            "apart": max(abs(x - other_x), abs(y + other_y)) / CELL, "hits": sum(force > 0 for force in forces[0]),
            "force": max(abs(a - b) for a, b in zip(forces[0][:steps], forces[1])) / max(forces[0]),
            "larger mesh": in_larger_mesh(start)}


def is_right(found):
    return found["code"] == 0 and found["hits"] > 3 and found["apart"] < 1e-9 and found["force"] < 1e-6 and found["larger mesh"] < 1e-9
