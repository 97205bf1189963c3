#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of doc/results/thesis-5.md and biaxial.md: soft grains compacted isotropically, sheared biaxially and unloaded, by MPM and by
BPM. A run that is there already is not repeated; `softgrain figures thesis-5` draws them."""
import argparse
import math
import pathlib

import numpy as np
from running import run_all, softgrain

SIDE, GRAINS, DIAMETER = 10.3e-3, 30, 1.9e-3  # of the packing in the gallery's scenes: square root of its box [m], grains [m]
AREA = 2.9e-6  # of a grain [m^2]
ROOM = 1.03  # of the sides of larger boxes: few grains between walls fill a box of that size, many jam before
CELL = 3.2e-4  # of the gallery's scene of soft grains [m]
CLOSING = 0.2  # volume strain while pressure rises on soft grains with inertia
RANGE = 32.  # of the pressures of a slow ramp
DENSITY = {"mpm": 990., "bpm": 2000.}
WORDS = {"Output/Fields every": "0", "Output/Measures": "all"}
TURN = 0.02  # of shear strain before the way back, over which the mean pressure there is averaged


def height(case):
    return SIDE * math.sqrt(case.number / GRAINS) * (case.room or (1. if case.number == GRAINS else ROOM))


def box(model, case):
    """Changes that give the gallery's scene another number of grains at about the same packing fraction."""
    number = case.number
    if number == GRAINS and not case.room:
        return {}
    side = f"{height(case):.6g}"
    changes = {"Packing/Number": str(number), "Packing/Upper": f"{side}, {side}", "Walls/top/Point": f"0, {side}",
               "Walls/right/Point": f"{side}, 0"}
    if model == "mpm":
        mesh = f"{1.3 * float(side):.6g}"  # sheared boxes are wider
        changes["Mesh/Upper"] = f"{mesh}, {mesh}"
    return changes


def legs(case):
    """Name, shear strain and sense of every stage after the isotropic ones."""
    if case.cycles:
        turns = [[f"back_{k}", f"forth_{k}"] for k in range(1, case.cycles + 1)]
        return [("shear", case.amplitude, 1)] + [(name, 2 * case.amplitude, sense) for turn in turns
                                                 for name, sense in zip(turn, (-1, 1))]
    if case.unload:
        return [("shear", case.unload, 1), ("unload", case.strain, -1)]
    return [("shear", case.strain, 1)]


def shear(first, case, speed):
    """Stages after the isotropic ones, whose names are @first."""
    changes = {"Stages/Names": ", ".join([*first, *(name for name, _, _ in legs(case))]),
               "Stages/shear/right/Drive": "pressure", "Stages/shear/right/Pressure": f"{case.pressure:g}"}
    for name, strain, sense in legs(case):
        changes.update({f"Stages/{name}/Stop/Shear strain": f"{strain:g}", f"Stages/{name}/top/Drive": "velocity",
                        f"Stages/{name}/top/Velocity": f"{sense * speed:g}"})
    return changes


def material_points(case):
    """Without inertia: time only orders the steps; the wall goes 0.2 cells in each, or --way."""
    step = 6.4e-5 * case.way / 0.2
    ramp = 6.4e-5 * (3 if case.number == GRAINS and case.pressure < 5e5 else 10)
    pressed = f"{case.pressure:g}*min(t/{ramp:g}, 1)"
    changes = {"Stages/compress/Stop/End time": f"{ramp:g}", "Stages/compress/top/Pressure": pressed,
               "Stages/compress/right/Pressure": pressed, "Stages/shear/Stop/Axial strain": "0",
               "Time/Time step": f"{step:g}", "Mesh/Upper": "17e-3, 17e-3",
               "Output/Snapshots every": f"{(1 if case.cycles else 2) * step:g}", **box("mpm", case), **shear(["compress"], case, 1.)}
    if case.moving:
        changes.update(with_inertia(case))
    return "gallery/biaxial_thirty_grains_mpm.prm", changes


def with_inertia(case):
    """What is different of soft grains that have inertia: walls close, and later shear, at an inertial number of --inertia; pressure rises from a
    tenth as slowly, since a light wall under pressure that nothing bears would fly."""
    slow = DIAMETER * math.sqrt(DENSITY["mpm"] / case.pressure)
    speed = case.inertia * height(case) / slow
    step, ramp = float(f"{case.way * CELL / speed:.4g}"), float(f"{CLOSING * slow / case.inertia:.4g}")
    pressed = f"{case.pressure:g}*min(0.1 + 0.9*t/{ramp:g}, 1)"
    changes = {"Time/Scheme": "moreau_jean", "Time/Time step": f"{step:g}", "Output/Snapshots every": f"{2 * step:g}",
               "Stages/close/Stop/Packing fraction": "0.8", "Stages/compress/Stop/End time": f"{1.2 * ramp:.4g}",
               **shear(["close", "compress"], case, speed)}
    for wall in ("top", "right"):
        changes.update({f"Stages/close/{wall}/Drive": "velocity", f"Stages/close/{wall}/Velocity": f"{speed:g}",
                        f"Stages/compress/{wall}/Pressure": pressed})
    return changes


def bonded(case):
    """At an inertial number of --inertia, which sets the speed of the wall; 200 states on the way. The whole pressure acts on the walls from
    the first step, as in the thesis. With --rise and --slow-ramp walls meet the grains at a moderate speed, and pressure rises in four
    times that in which stress crosses the box, or slower: at once is a blow, which bonds remember."""
    slow = DIAMETER * math.sqrt(DENSITY["bpm"] / case.pressure)  # over which the rate of strain is the inertial number [s]
    speed = case.inertia * height(case) / slow
    way = 0.5 * sum(strain for _, strain, _ in legs(case)) * height(case)
    crossing = slow * height(case) / DIAMETER
    ramp, rising = 4 * crossing, "t/{0:.4g}"
    if case.slow_ramp:  # the isotropic line of all pressures in one run
        ramp, rising = case.slow_ramp * 1e-3, f"exp({math.log(RANGE):.4f}*(t/{{0:.4g}}-1))"
    slowly = case.rise or case.slow_ramp
    rest = 2e-3 * height(case) / SIDE if slowly else 1.5 * crossing
    changes = {"Materials/grain/Law": case.law, "Stages/compact/Stop/End time": f"{rest:.4g}",
               "Output/Snapshots every": f"{ramp / 100 if case.slow_ramp else way / speed / 200:.3g}", "Output/History every": "20",
               **box("bpm", case), **shear(["close", "press", "compact"] if slowly else ["compact"], case, speed)}
    if slowly:
        changes.update({"Stages/close/Stop/Packing fraction": "0.78", "Stages/press/Stop/End time": f"{ramp:.4g}"})
    if case.damping:
        grains = case.number * AREA * DENSITY["bpm"]
        changes["Stages/shear/right/Damping"] = f"{case.damping * math.sqrt(0.1 * grains * case.pressure):.3g}"
    pressed = f"{case.pressure:g}*{rising.format(ramp)}"
    for wall in ("top", "right"):
        changes[f"Stages/compact/{wall}/Pressure"] = f"{case.pressure:g}"
        if slowly:
            changes.update({f"Stages/close/{wall}/Drive": "velocity", f"Stages/close/{wall}/Velocity": "2",
                            f"Stages/press/{wall}/Drive": "pressure", f"Stages/press/{wall}/Pressure": pressed})
    if case.thesis_primaries:
        changes.update({"Primaries/Smallest diameter": "0.07e-3", "Primaries/Largest diameter": "0.13e-3"})
    return "gallery/biaxial_thirty_grains_bpm.prm", changes


def repeating(model):
    """The box becomes a cell that repeats: its sides are driven as the walls are."""
    changes = {"Packing/Periodic": "x, y", **{f"Walls/{side}/Type": "periodic" for side in ("bottom", "top", "left", "right")}}
    return {**changes, "Mesh/Lower": "-3e-3, -3e-3"} if model == "mpm" else changes


def pressure_at_turn(folder):
    """(s1 + s2)/2 on the walls over the last TURN of shear strain of the stage "shear" of a run [Pa]."""
    rows = softgrain.open(folder).history_table
    stage = rows["stage"].astype(int)
    width, height = (rows[f"{b}_position_m"] - rows[f"{a}_position_m"] for a, b in (("left", "right"), ("bottom", "top")))
    strain, turn = np.log(width / height), stage == 2
    kept = turn & (strain >= strain[turn][-1] - TURN)
    across = 0.5 * (rows["top_force_N_per_m"] + rows["bottom_force_N_per_m"]) / width
    return float(np.mean((0.5 * across + 0.25 * (rows["left_force_N_per_m"] + rows["right_force_N_per_m"]) / height)[kept]))


def mean_held(changes, turned):
    """The way back of the run in @turned with the mean pressure held that the walls had when it began."""
    held = {"Stages/unload/right/Drive": "mean_pressure", "Stages/unload/right/Mean pressure": f"{pressure_at_turn(turned):.5g}"}
    damping = changes.get("Stages/shear/right/Damping")
    return {**changes, **held, **({"Stages/unload/right/Damping": damping} if damping else {})}


SCENES = {"mpm": material_points, "bpm": bonded}
COMPACTED = {"mpm": "stage-compress.h5", "bpm": "stage-compact.h5"}


def cases(arguments):
    """Name, scene and changes of every run."""
    further = dict(text.split("=", 1) for text in arguments.set)
    # Of a packing that is prepared the path that does not turn round is there already.
    turns = arguments.unload if arguments.prepared and arguments.unload else [0., *arguments.unload]
    for pressure in arguments.pressures:
        for friction in arguments.friction:
            for seed in arguments.seeds:
                for unload in turns:
                    case = argparse.Namespace(**{**vars(arguments), "pressure": pressure * 1e6, "unload": unload})
                    name = f"{arguments.model}-{arguments.number}-mu{friction:g}-p{pressure:g}-seed{seed}" + ("-periodic" if case.periodic else "")
                    prepared = arguments.prepared and arguments.prepared / name / COMPACTED[arguments.model]
                    name += (f"-unload{unload:g}" if unload else "") + (f"-cycles{case.cycles}" if case.cycles else "")
                    scene, changes = SCENES[arguments.model](case)
                    changes = {**WORDS, **changes, **(repeating(arguments.model) if case.periodic else {}),
                               "Contact/Friction": f"{friction:g}", "Packing/Seed": str(seed), **further}
                    yield name + case.suffix, scene, changes, prepared
                    if unload and case.hold_mean:
                        turned = arguments.folder / (name + case.suffix)
                        yield name + case.suffix + "-mean", scene, mean_held(changes, turned), turned / "stage-shear.h5"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", type=pathlib.Path, help="for the output folders of the runs")
    parser.add_argument("--model", choices=sorted(SCENES), required=True)
    parser.add_argument("--number", type=int, default=GRAINS, help="grains (default: %(default)s; the thesis: 300)")
    parser.add_argument("--pressures", type=float, nargs="+", default=[0.2, 0.4, 0.8, 1.6, 3.2], help="[MPa]")
    parser.add_argument("--friction", type=float, nargs="+", default=[0.])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--strain", type=float, default=0.8, help="shear strain of every stage (default: %(default)s)")
    parser.add_argument("--unload", type=float, nargs="*", default=[], help="also runs that turn round at these shear strains")
    parser.add_argument("--hold-mean", action="store_true", help="the way back also with the mean pressure held that it begins at")
    parser.add_argument("--cycles", type=int, default=0, help="shear to and fro so often")
    parser.add_argument("--amplitude", type=float, default=0.05, help="shear strain of cycles (default: %(default)s)")
    parser.add_argument("--inertia", type=float, default=1e-3, help="inertial number, bpm and --moving (default: %(default)s)")
    parser.add_argument("--moving", action="store_true", help="mpm: with inertia")
    parser.add_argument("--prepared", type=pathlib.Path, metavar="FOLDER",
                        help="go on from the compacted state of the run of the same name, without turning round, in this folder")
    parser.add_argument("--periodic", action="store_true", help="a cell that repeats in place of walls")
    parser.add_argument("--room", type=float, help="of the sides of a box whose packing jams, over those that thirty grains have")
    parser.add_argument("--law", choices=("power_potential", "power_law"), default="power_potential",
                        help="bpm: (3.1) as an energy or as a force (default: %(default)s)")
    parser.add_argument("--rise", action="store_true", help="bpm: pressure rises, in place of the whole from the first step")
    parser.add_argument("--damping", type=float, help="bpm: of the wall on the right while sheared, over sqrt(m p)")
    parser.add_argument("--slow-ramp", type=float, default=0., metavar="MS", help="bpm: pressure rises 32 times in this time [ms]")
    parser.add_argument("--way", type=float, default=0.2, help="of the wall in a step, mpm [cells] (default: %(default)s)")
    parser.add_argument("--thesis-primaries", action="store_true", help="bpm: of 0.07 to 0.13 mm, about 250 to a grain")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of every run")
    parser.add_argument("--suffix", default="", help="of the names of the folders")
    parser.add_argument("--threads", type=int, default=0)
    arguments = parser.parse_args()
    print("| run | steps | shear strain | seconds |\n|---|---|---|---|")
    for name, changes, summary, rows in run_all(arguments.program, arguments.folder, cases(arguments), arguments.threads):
        sheared = changes["Stages/Names"].split(", ").index("shear") + 1
        strain = [math.log(1 / (row["top_position_m"] - row["bottom_position_m"])) -
                  math.log(1 / (row["right_position_m"] - row["left_position_m"])) for row in rows]
        first = max((i for i, row in enumerate(rows) if row["stage"] < sheared), default=0)  # a way back alone begins with its first row
        print(f"| {name} | {summary['steps']} | {strain[-1] - strain[first]:.2f} | {summary['wall_seconds']:.0f} |", flush=True)


if __name__ == "__main__":
    main()
