#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""A ball that two rough plates drag along a side wall, which lets it neither roll nor go: friction over the way that plates slide past the
middle of the ball, against Mindlin's partial slip, and stiffness along over that across. The table of doc/results/three-dimensions.md."""
import math
import pathlib

import numpy as np

from running import parser_of, run, softgrain

SCENE = pathlib.Path(__file__).resolve().parent / "partial_slip_of_a_ball.prm"
YOUNG, POISSON, RADIUS, FRICTION, STUCK = 10e6, 0.3, 5e-3, 0.3, 5.0  # of the scene [Pa, m]; friction with which nothing slips
SHEAR, CONTACT = YOUNG / 2 / (1 + POISSON), YOUNG / (1 - POISSON**2)
SHARES = (0.4, 0.6, 0.8, 0.9)  # of the largest friction


def changes_of(cells, pressed, cut, friction, end):
    """Parameters of a run with @cells in the radius whose plates come nearer by @pressed radii each, until @end."""
    h, speed = RADIUS / cells, pressed * RADIUS
    low = -RADIUS - (1.2 + cut) * h
    return {"Mesh/Cell size": h, "Mesh/Lower": ", ".join([f"{low:.6g}", f"{low + 0.3 * cut * h:.6g}", f"{low + 0.6 * cut * h:.6g}"]),
            "Mesh/Upper": ", ".join([f"{-low:.6g}"] * 3), **{f"Walls/{name}/Velocity": f"t < 1 ? {speed} : 0" for name in ("bottom", "top")},
            **{f"Walls/{name}/Tangential velocity": f"t < 1 ? 0 : {speed}" for name in ("bottom", "top")},
            **{f"Walls/{name}/Friction": friction for name in ("bottom", "top")},
            "Walls/side/Point": f"{RADIUS * (1 + 0.1 * pressed)}, 0, 0", "Stop/End time": end}


def pushed(program, folder, changes, pressed):
    """Slide of plates past the middle of the ball [m], friction and load of a plate [N] while they slide; the summary."""
    summary, rows = run(program, SCENE, folder, changes, threads=1, again=False)
    by_time = {row["time_s"]: row for row in rows}
    slide, friction, load = [], [], []
    for state in softgrain.open(folder):
        if state.time < 1 - 1e-9:
            continue
        row = by_time[min(by_time, key=lambda time: abs(time - state.time))]
        slide.append(pressed * RADIUS * (state.time - 1) - state.bodies.center_m[0][0])
        friction.append(0.5 * abs(row["bottom_tangential_force_N"] + row["top_tangential_force_N"]))
        load.append(0.5 * (row["top_force_N"] + row["bottom_force_N"]))
    return np.array(slide), np.array(friction), np.array(load), summary


def from_the_start(slide, share):
    """The slide from where a line through the light states has no force, and metres for a unit of @share there."""
    light = (share > 0.02) & (share < 0.15)
    along, start = np.polyfit(share[light], slide[light], 1)
    return slide - start, along


def main():
    parser = parser_of(__doc__, "partial_slip_of_a_ball")
    parser.add_argument("--cells", type=float, nargs="+", default=(4, 6), help="in the radius")
    parser.add_argument("--pressed", type=float, nargs="+", default=(0.03, 0.06, 0.1), help="way of each plate in radii")
    parser.add_argument("--cut", type=float, default=0.2, help="shift of the grid in cells")
    parser.add_argument("--end", type=float, default=2.4, help="time [s]")
    arguments = parser.parse_args()
    for cells in arguments.cells:
        for pressed in arguments.pressed:
            found = []
            for friction in (FRICTION, STUCK):
                changes = changes_of(cells, pressed, arguments.cut, friction, arguments.end)
                folder = arguments.folder / f"{cells:g}-{pressed}-{friction}"
                slide, force, load, summary = pushed(arguments.program, folder, changes, pressed)
                share = force / (FRICTION * load)
                found.append((*from_the_start(slide, share), share))
            radius = (3 * load[0] * RADIUS / (4 * CONTACT)) ** (1 / 3)
            largest = 3 * (2 - POISSON) * FRICTION * load[0] / (16 * SHEAR * radius)  # slide at which all slips
            (slide, _, share), (stuck, along, stuck_share) = found
            line = []
            for at in SHARES:
                slip = np.interp(at, share, slide) - np.interp(at, stuck_share, stuck)
                line.append(f"{slip / largest:.3f} ({1 - (1 - at) ** (2 / 3) - 2 / 3 * at:.3f})" if share.max() > at else "")
            print(f"| {cells:g}, {pressed} | {radius / RADIUS:.3f}, {radius / RADIUS * cells:.2f} | {along / largest * 1.5:.3f} | " + " | ".join(line)
                  + f" | {share.max():.4f} | {summary['processor_seconds']:.0f} |", flush=True)


if __name__ == "__main__":
    main()
