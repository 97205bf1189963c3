#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs of doc/results/biaxial.md: thirty soft grains in a cell that repeats, compacted and sheared by a lattice that slides, by MPM
and by BPM. A run that is there already is not repeated."""
import argparse
import math
import pathlib

from chapter_five import DENSITY, DIAMETER, SIDE, WORDS
from running import run_all

GRAINS = 30


def material_points(case):
    """Without inertia: time only orders the steps; the side slides 0.3 cells in each, or --way."""
    step = 6.4e-5 * case.way / 0.3
    pressed = f"{case.pressure:g}*min(t/1.92e-4, 1)"
    changes = {"Stages/compress/top/Pressure": pressed, "Stages/compress/right/Pressure": pressed,
               "Stages/shear/top/Pressure": f"{case.pressure:g}", "Stages/shear/Stop/End time": f"{case.strain * SIDE / 1.5:.4g}",
               "Time/Time step": f"{step:g}", "Output/Snapshots every": f"{2 * step:g}"}
    return "gallery/simple_shear_periodic.prm", changes


def bonded(case):
    """The same preparation as between walls (chapter_five.py); @case.inertia sets the speed of the lattice."""
    slow = DIAMETER * math.sqrt(DENSITY["bpm"] / case.pressure)
    speed, ramp = case.inertia * SIDE / slow, 4 * slow * SIDE / DIAMETER
    time = case.strain * SIDE / speed
    changes = {"Stages/Names": "close, press, compact, shear", "Stages/close/Stop/Packing fraction": "0.78",
               "Stages/press/Stop/End time": f"{ramp:.4g}", "Stages/shear/Stop/End time": f"{time:.4g}",
               "Stages/shear/top/Pressure": f"{case.pressure:g}", "Stages/shear/top/Tangential velocity": f"{-speed:g}",
               "Output/Snapshots every": f"{time / 200:.3g}", "Output/History every": "20"}
    for wall in ("top", "right"):
        changes.update({f"Stages/close/{wall}/Drive": "velocity", f"Stages/close/{wall}/Velocity": "2",
                        f"Stages/press/{wall}/Drive": "pressure", f"Stages/press/{wall}/Pressure": f"{case.pressure:g}*t/{ramp:.4g}",
                        f"Stages/compact/{wall}/Pressure": f"{case.pressure:g}"})
    return "gallery/simple_shear_periodic_bpm.prm", changes


SCENES = {"mpm": material_points, "bpm": bonded}


def cases(arguments):
    """Name, scene and changes of every run."""
    further = dict(text.split("=", 1) for text in arguments.set)
    for pressure in arguments.pressures:
        for friction in arguments.friction:
            for seed in arguments.seeds:
                name = f"simple-{arguments.model}-{GRAINS}-mu{friction:g}-p{pressure:g}-seed{seed}{arguments.suffix}"
                scene, changes = SCENES[arguments.model](argparse.Namespace(**{**vars(arguments), "pressure": pressure * 1e6}))
                yield name, scene, {**WORDS, **changes, "Contact/Friction": f"{friction:g}", "Packing/Seed": str(seed), **further}, None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", type=pathlib.Path, help="for the output folders of the runs")
    parser.add_argument("--model", choices=sorted(SCENES), required=True)
    parser.add_argument("--pressures", type=float, nargs="+", default=[0.4], help="[MPa]")
    parser.add_argument("--friction", type=float, nargs="+", default=[0.])
    parser.add_argument("--seeds", type=int, nargs="+", default=[1])
    parser.add_argument("--strain", type=float, default=1.2, help="way of the lattice over the height (default: %(default)s)")
    parser.add_argument("--inertia", type=float, default=4e-3, help="inertial number, bpm (default: %(default)s)")
    parser.add_argument("--way", type=float, default=0.3, help="of the side in a step, mpm [cells] (default: %(default)s)")
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of every run")
    parser.add_argument("--suffix", default="", help="of the names of the folders")
    parser.add_argument("--threads", type=int, default=0)
    arguments = parser.parse_args()
    for name, _, summary, _ in run_all(arguments.program, arguments.folder, cases(arguments), arguments.threads):
        print(f"{name}: {summary['steps']} steps, {summary['wall_seconds']:.0f} s", flush=True)


if __name__ == "__main__":
    main()
