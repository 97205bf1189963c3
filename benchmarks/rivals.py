#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Rivals side by side: the tables and the figure of doc/results/rivals.md.

    rivals.py PROGRAM FOLDER [--rounds 3] [--only disk] [--table FILE] [--picture FILE]

Every case runs --rounds times, all of them in turns, on one thread; seconds are processor time of the whole process, its start
included, the median of the rounds. A rival that is not here is named and left out. Forces come from the last round and are compared with
reference/, which getfem_disk.py made with --fine 0.006.
"""
import argparse
import csv
import importlib.util
import pathlib
import shutil
import statistics
import subprocess
import sys

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "contrib/results"))

from processor import seconds_of  # noqa: E402
from running import PARAMETERS, softgrain  # noqa: E402
from subgrid import mesh  # noqa: E402

RADIUS, YOUNG = 5e-3, 10e6
WAYS = {"disk": (0.015, 0.03, 0.06, 0.105, 0.21, 0.3), "plates": (0.01, 0.02, 0.05, 0.1, 0.13, 0.15)}
CELLS = (1.2e-3, 8.5e-4, 6e-4, 4.2e-4, 2.9e-4, 2.1e-4)
RINGS = ("3,4", "5,6", "8,9", "12,13", "17,19")
QUIET = {"Output/Number of field outputs": 1, "Output/Fields every": 0, "Output/Snapshots every": 0}
THIRTY = "gallery/thirty_grains_quasi_static_mpm.prm"


class Case:
    """One program with one setting: its command, and how its forces are read."""

    def __init__(self, scene, code, setting, command, forces=None, reference=None):
        self.scene, self.code, self.setting, self.command, self.forces, self.reference = scene, code, setting, command, forces, reference
        self.seconds = []

    def run(self):
        """Processor seconds of one run are added to the others."""
        self.seconds.append(seconds_of(self.command))

    def errors(self):
        """Relative, at the ways of the scene."""
        if self.forces is None:
            return []
        ways, forces = self.forces()
        exact = np.genfromtxt(HERE / "reference" / self.reference, delimiter=",", names=True)
        return [float(np.interp(way, ways, forces) / np.interp(way, exact["way_over_R"], exact["force_over_E_R"]) - 1) for way in WAYS[self.scene]]


def here(name):
    """Whether the rival can be run; says so where it cannot."""
    found = importlib.util.find_spec("getfem") is not None if name == "getfem" else shutil.which(name) is not None
    if not found:
        print(f"{name} is not here and left out", file=sys.stderr)
    return found


def table_of(path):
    """What a deck wrote."""
    def read():
        found = np.genfromtxt(path, delimiter=",", names=True)
        return found["way_over_R"], found["force_over_E_R"]
    return read


def ours(program, folder, scene, changes):
    """The command of a run of ours."""
    words = [program, "run", PARAMETERS / scene, "--threads", 1, "--overwrite", "--output", folder]
    for name, value in {**QUIET, **changes}.items():
        words += ["--set", f"{name}={value}"]
    return words


def our_forces(folder):
    def read():
        table = softgrain.open(str(folder)).history_table
        return table["time_s"], table["top_force_N_per_m"] / (YOUNG * RADIUS)
    return read


def disks(program, folder):
    """One disk between two plates, twenty steps: law of softgrain, and that of CalculiX."""
    scene = "verification/line_contact.prm"
    for cell in CELLS:
        for cut in (0, 0.3, 0.6):
            place = folder / f"disk-{cell}-{cut}"
            yield Case("disk", "softgrain", f"{cell * 1e3:g} mm, cut {cut}", ours(program, place, scene, {**mesh(cell, cut), "Time/Time step": 0.015}),
                       our_forces(place), "disk.csv")
    if here("getfem"):
        for rings in RINGS:
            place = folder / f"getfem-{rings}.csv"
            yield Case("disk", "GetFEM", f"rings {rings}", ["/usr/bin/python3", HERE / "getfem_disk.py", "--rings", rings, "--out", place], table_of(place), "disk.csv")
    if here("ccx"):
        for rings in RINGS[:4]:
            place = folder / f"calculix-{rings}"
            yield Case("disk", "CalculiX", f"rings {rings}", ["/usr/bin/python3", HERE / "calculix_disk.py", place, "--rings", rings, "--out", f"{place}.csv"],
                       table_of(f"{place}.csv"), "disk-ciarlet.csv")
        place = folder / "disk-ciarlet"
        yield Case("disk", "softgrain", "0.29 mm, CalculiX's law",
                   ours(program, place, scene, {"Time/Time step": 0.015, "Materials/gel/Law": "mooney_rivlin", "Materials/gel/Mooney-Rivlin/Young's modulus": YOUNG,
                                                "Materials/gel/Mooney-Rivlin/Poisson's ratio": 0.45,
                                                "Materials/gel/Mooney-Rivlin/Share of the second invariant": 0}),
                   our_forces(place), "disk-ciarlet.csv")


def plates(program, folder):
    """One disk between four plates, thirty steps."""
    place = folder / "plates"
    yield Case("plates", "softgrain", "0.29 mm", ours(program, place, "verification/four_plates.prm", {}), our_forces(place), "plates.csv")
    if here("getfem"):
        place = folder / "getfem-plates.csv"
        yield Case("plates", "GetFEM", "rings 12,13", ["/usr/bin/python3", HERE / "getfem_disk.py", "--plates", 4, "--to", 0.15, "--steps", 30, "--out", place],
                   table_of(place), "plates.csv")


def write_packing(program, folder):
    """Places and radii of the thirty disks at the start, for the rivals."""
    place, table = folder / "packing", folder / "packing.csv"
    subprocess.run([str(word) for word in ours(program, place, THIRTY, {"Stop/End time": 3.2e-5, "Output/Snapshots every": 3.2e-5})], check=True, capture_output=True)
    bodies = next(iter(softgrain.open(str(place)))).bodies
    radii = np.sqrt(bodies["reference_area_m2"] / np.pi)
    np.savetxt(table, np.column_stack([bodies["center_m"][:, :2], radii]), delimiter=",", header="x_m,y_m,radius_m", comments="", fmt="%.12g")
    return table


def grains(program, folder):
    """Thirty disks in a box, loose to .95."""
    packing = write_packing(program, folder)
    slow = {"Walls/top/Velocity": 0.2, "Time/CFL multiple": 100, "Stop/End time": 1}
    for setting, scene, changes in (("at rest", THIRTY, {}), ("at rest, friction 0.5", THIRTY, {"Contact/Friction": 0.5}),
                                    ("0.2 m/s", "gallery/thirty_grains_mpm.prm", slow)):
        yield Case("grains", "softgrain", setting, ours(program, folder / f"grains {setting}", scene, changes))
    if here("lmp"):
        yield Case("grains", "LAMMPS", "springs, 0.2 m/s", ["/usr/bin/python3", HERE / "lammps_grains.py", packing, folder / "lammps", "--out", folder / "lammps.csv"])


def write(path, cases, unit):
    """One row a case."""
    with open(path, "w", encoding="utf-8", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["scene", "code", "setting", "seconds", "units", *(f"error_{n}" for n in range(1, 7))])
        for case in cases:
            seconds = statistics.median(case.seconds)
            out.writerow([case.scene, case.code, case.setting, f"{seconds:.3f}", f"{seconds / unit:.3f}" if unit else "", *(f"{error:.5f}" for error in case.errors())])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="build/release/bin/softgrain")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", choices=("disk", "plates", "grains", "units"), help="one scene; units: the cases that have a figure to reach, and the unit")
    parser.add_argument("--table", type=pathlib.Path, help="rows of all cases, FOLDER/rivals.csv where it is not said")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure, drawn from the table and the runs in FOLDER")
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    folder.mkdir(parents=True, exist_ok=True)
    table = arguments.table or folder / "rivals.csv"
    if arguments.rounds:
        program = arguments.program.resolve()
        makers = {"disk": disks, "plates": plates, "grains": grains}
        cases = [case for name, maker in makers.items() if arguments.only in (None, "units", name) for case in maker(program, folder)]
        if arguments.only == "units":
            cases = [case for case in cases if (case.scene, case.code) == ("grains", "softgrain") or case.setting in ("rings 12,13", "0.29 mm, cut 0", "0.29 mm")]
            cases = [case for case in cases if case.code != "CalculiX"]
        for number in range(arguments.rounds):
            for case in cases:
                case.run()
            print(f"round {number + 1} of {arguments.rounds}", flush=True)
        unit = next((statistics.median(case.seconds) for case in cases if (case.scene, case.code, case.setting) == ("disk", "GetFEM", "rings 12,13")), None)
        write(table, cases, unit)
        print(table.read_text(encoding="utf-8"), end="")
    if arguments.picture:
        from drawn import draw
        draw(arguments.picture, table, folder)


if __name__ == "__main__":
    main()
