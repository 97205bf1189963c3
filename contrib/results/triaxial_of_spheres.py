#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Triaxial compression of balls, at rest or with inertia, in a box whose sides keep one pressure: deviator over mean pressure and change of
volume over the deviatoric strain. The tables of doc/results/three-dimensions.md."""
import math
import pathlib

import numpy as np

from running import RunFailed, parser_of, rows_of, softgrain

SCENE = pathlib.Path(__file__).resolve().parent / "triaxial_of_spheres.prm"
DIAMETER, YOUNG, SPEED, DENSITY = 10e-3, 10e6, 1e-3, 1000  # mean [m], [Pa], of walls at rest [m/s], [kg/m^3]
GATHERS = 3.  # speed of the walls that gather over that of the top later
RAMP, WAIT = 3., 9.  # of the pressure, and until the top moves, in the time in which it moves a ball by its diameter
SIDES = (("left", "right"), ("front", "back"), ("bottom", "top"))


def changes_of(arguments):
    """Parameters of a run: balls that fill .5 of a cube, gathered to --gathered, under --pressure times Young's modulus."""
    edge = DIAMETER * (arguments.number * math.pi / 6 / 0.5) ** (1 / 3)
    gathered = edge * (0.5 / arguments.gathered) ** (1 / 3)
    points = {f"Walls/{far}/Point": ", ".join(f"{edge:.7g}" if d == axis else "0" for d in range(3))
              for axis, (_, far) in enumerate(SIDES)}
    gather, shear = (SPEED, SPEED) if not arguments.moving else speeds_of(arguments, gathered)
    return {"Packing/Number": arguments.number, "Packing/Seed": arguments.seed, "Packing/Upper": ", ".join([f"{edge:.7g}"] * 3), **points,
            "Contact/Friction": arguments.friction, "Stages/gather/Stop/End time": f"{(edge - gathered) / gather:.5g}",
            **{f"Stages/press/{far}/Pressure": arguments.pressure * YOUNG for _, far in SIDES},
            "Stages/shear/Stop/End time": f"{(1 - math.exp(-arguments.strain)) * gathered / shear:.5g}",
            "Mesh/Upper": f"{1.35 * edge:.6g}, {1.35 * edge:.6g}, {edge + 1e-4:.6g}",
            **(with_inertia(arguments, gather, shear) if arguments.moving else {})}


def slow_time(arguments):
    """In which the pressure moves a ball by about its diameter [s]."""
    return DIAMETER * math.sqrt(DENSITY / (arguments.pressure * YOUNG))


def speeds_of(arguments, height):
    """Of the walls that gather and of the top later, which shears at the inertial number --moving [m/s]."""
    shear = arguments.moving * height / slow_time(arguments)
    return GATHERS * shear, shear


def with_inertia(arguments, gather, shear):
    """Changes of a run in which balls and the walls under pressure have inertia."""
    slow = slow_time(arguments)
    pressed = f"{arguments.pressure * YOUNG:g}*min(0.1 + t/{RAMP * slow:.4g}, 1)"
    return {"Time/Scheme": "moreau_jean", "Time/Time step": 0, "Time/Wall way": 0, "Time/CFL multiple": arguments.cfl,
            **{f"Stages/gather/{far}/Velocity": f"{gather:.5g}" for _, far in SIDES},
            **{f"Stages/press/{far}/Pressure": pressed for _, far in SIDES},
            "Stages/press/Stop/End time": f"{WAIT * slow:.5g}", "Stages/shear/top/Velocity": f"{shear:.5g}"}


def path_of(run):
    """(deviatoric strain, q/p, p/E, volumetric strain, coordination, packing fraction) of the states after walls press."""
    rows = rows_of(run)
    edges = np.array([[row[f"{far}_position_m"] - row[f"{near}_position_m"] for near, far in SIDES] for row in rows])
    force = np.array([[0.5 * (row[f"{near}_force_N"] + row[f"{far}_force_N"]) for near, far in SIDES] for row in rows])
    stress = force * edges / edges.prod(axis=1)[:, None]
    start = max(i for i in range(len(rows)) if abs(edges[i, 2] - edges[-1, 2]) > 0 and rows[i]["stage"] != rows[-1]["stage"])
    strain = np.log(edges[start] / edges)
    side, p = strain[:, :2].mean(axis=1), stress.mean(axis=1)
    q = stress[:, 2] - stress[:, :2].mean(axis=1)
    table = np.column_stack((2 / 3 * (strain[:, 2] - side), q / np.where(p > 0, p, 1), p / YOUNG, strain.sum(axis=1),
                             [row["coordination"] for row in rows], [row["packing_fraction"] for row in rows]))
    return table[start:]


def main():
    parser = parser_of(__doc__, "triaxial_of_spheres")
    parser.add_argument("--number", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--friction", type=float, default=0.0, help="between balls; walls are smooth")
    parser.add_argument("--gathered", type=float, default=0.66, help="packing fraction that walls gather")
    parser.add_argument("--pressure", type=float, default=0.02, help="of the sides, over Young's modulus")
    parser.add_argument("--strain", type=float, default=0.45, help="of the height, at the end")
    parser.add_argument("--moving", type=float, default=0., metavar="I", help="with inertia, at this inertial number")
    parser.add_argument("--cfl", type=float, default=8., help="step with inertia, of that in which a wave goes through a cell")
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--limit", type=float, default=7200, help="seconds the run may take")
    arguments = parser.parse_args()
    folder = arguments.folder / f"{arguments.number}-{arguments.seed}-{arguments.friction:g}-{arguments.pressure:g}{f'-moving{arguments.moving:g}' if arguments.moving else ''}"
    try:
        softgrain.run(str(SCENE), set=changes_of(arguments), output=str(folder), threads=arguments.threads,
                      program=str(arguments.program), timeout=arguments.limit, overwrite=True, verbose=True)
    except RunFailed as trouble:
        print(str(trouble).strip().splitlines()[-1])
    run = softgrain.open(folder)
    path, rows = path_of(run), rows_of(run)
    np.savetxt(folder / "path.csv", path, fmt="%.6g", delimiter=",", header="strain,q_over_p,p_over_E,volumetric_strain,coordination,fraction",
               comments="")
    print("| strain | q/p | p/E | volumetric strain | Z | packing fraction |\n" + "|---" * 6 + "|")
    for at in (0.0, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5):
        if at <= path[-1, 0]:
            print("| " + " | ".join(f"{np.interp(at, path[:, 0], column):.3f}" for column in path.T) + " |")
    print(f"{len(rows) - 1} steps, {sum(row['newton_iterations'] for row in rows):.0f} iterations, "
          f"{run.summary.get('processor_seconds', float('nan')):.0f} s")


if __name__ == "__main__":
    main()
