# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk rolls on a rough line and slides on one with little friction, with inertia and met by rays. On a line of one piece, of
fourteen, and on one drawn the other way it comes to the same place; so it does on a plane. A run that goes on from a checkpoint comes
to the same numbers.
"""

ENDS = (-7e-3, 15e-3)


def points(n):
    return "; ".join(f"{ENDS[0] + (ENDS[1] - ENDS[0]) * k / n!r}, 0" for k in range(n + 1))


def speed(run):
    return run.states[-1].bodies.velocity_m_per_s[0, 0]


def place(run):
    return run.states[-1].bodies.center_m[0, 0]


def measure(start):
    found = {}
    for friction in (0.3, 0.03):
        rough = f"Obstacles/line/Friction={friction}"
        runs = {"one": start("disk_on_a_line.prm", f"Obstacles/line/Points={points(1)}", rough, codes=(0,)),
                "many": start("disk_on_a_line.prm", f"Obstacles/line/Points={points(14)}", rough, codes=(0,)),
                "turned": start("disk_on_a_line.prm", "Obstacles/line/Points=15e-3, 0; -7e-3, 0", rough, codes=(0,)),
                "plane": start("disk_on_a_line.prm", "Obstacles/Names=", "Walls/Names=bottom", "Walls/bottom/Point=0, 0",
                               f"Walls/bottom/Friction={friction}", codes=(0,))}
        one = place(runs["one"])
        found[friction] = {name: abs(place(run) / one - 1) for name, run in runs.items()}
    half = start("disk_on_a_line.prm", f"Obstacles/line/Points={points(14)}", "Stop/End time=0.06", codes=(0,))
    on = start("disk_on_a_line.prm", f"Obstacles/line/Points={points(14)}", codes=(0,),
               words=("--restart", max(half.folder.glob("state-*.h5"))))
    whole = start("disk_on_a_line.prm", f"Obstacles/line/Points={points(14)}", codes=(0,))
    found["restart"] = abs(speed(on) / speed(whole) - 1)
    found["slides"] = speed(runs["one"])
    return found


def is_right(found):
    # Without rolling: the slope less the friction, from the time when gravity is there on the average.
    slides = (1.961161 - 0.03 * 9.805807) * (0.1 - 0.025)
    # While it rolls, rays come and go below it at other places. It starts with a bounce, so speeds differ by ten times that.
    return (found["restart"] < 1e-12 and abs(found["slides"] / slides - 1) < 0.02 and max(found[0.03].values()) < 2e-5
            and max(found[0.3].values()) < 5e-4)
