#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Elastic-plastic spheres in a box whose six walls come nearer, as points with the contact law MDR of LAMMPS (Debian 13's lammps, of February
2025): the rival's deck of doc/results/rivals.md. The law knows a yield stress and what a confined grain has left to go.

    lammps_spheres.py SPHERES FOLDER [--from 3] [--to 2.002] [--speed 0.1] [--friction 0.5] [--out TABLE]
    lammps_spheres.py --new SEED SPHERES

SPHERES is a table x_m,y_m,z_m,radius_m with the box about the origin; --new draws one of twelve spheres. The table that comes out has the
time, the edge of the box, the part of it that spheres fill and the mean stress on the two walls of each direction.
"""
import argparse
import math
import pathlib
import random
import shutil
import subprocess
import sys

import deck_tables

YOUNG, POISSON, YIELD, DENSITY = 1e9, 0.3, 50e6, 1000.
WALLS = (("left", "1 0 0"), ("right", "-1 0 0"), ("front", "0 1 0"), ("back", "0 -1 0"), ("bottom", "0 0 1"), ("top", "0 0 -1"))
RADII = (0.6,) * 4 + (0.5,) * 2 + (0.4,) * 6
LEAST_GAP, EDGE = 0.02, 3.

DECK = """units si
atom_style sphere 1
atom_modify map array
comm_modify vel yes
boundary f f f
newton off
region box block -{room:.9g} {room:.9g} -{room:.9g} {room:.9g} -{room:.9g} {room:.9g}
create_box 1 box
{spheres}
set type 1 density {density}
pair_style granular
pair_coeff * * {law}
neighbor {skin:.9g} bin
neigh_modify delay 0 every 1
timestep {step:.9g}
variable way equal "{speed}*step*dt"
variable away equal "-{speed}*step*dt"
{walls}
fix time all nve/sphere
run 0
{forces}
thermo {every}
thermo_style custom step {columns}
thermo_modify lost error norm no
run {steps}
"""


def drawn(seed):
    """Spheres that lie anywhere in the box and do not touch."""
    draw = random.Random(seed)
    spheres = []
    for radius in RADII:
        for _ in range(1000000):
            place = [draw.uniform(radius - EDGE / 2, EDGE / 2 - radius) for _ in range(3)]
            if all(math.dist(place, other[:3]) > radius + other[3] + LEAST_GAP for other in spheres):
                spheres.append((*place, radius))
                break
        else:
            sys.exit(f"no room for {len(RADII)} spheres with seed {seed}")
    return spheres


def read_spheres(path):
    """(x, y, z, radius) of a table."""
    return [tuple(float(word) for word in line.split(",")) for line in path.read_text(encoding="utf-8").splitlines()[1:] if line]


def deck(spheres, arguments):
    """The text of the input file."""
    least, most = min(radius for *_, radius in spheres), max(radius for *_, radius in spheres)
    bulk = YOUNG / (3 * (1 - 2 * POISSON))
    # What the manual of the law advises.
    step = 0.08 * (DENSITY * 4 / 3 * math.pi * least**3 / (bulk * least))**0.5
    law = (f"mdr {YOUNG:g} {POISSON:g} {YIELD:g} 0 {arguments.confinement:g} {arguments.damping:g} damping {arguments.damping_kind} "
           f"tangential linear_history {2 / 7 * YOUNG * most:.9g} 0 {arguments.friction:g}")
    half = arguments.start / 2
    walls, forces, columns = [], [], ["v_way"]
    for name, normal in WALLS:
        axis = next(d for d, word in enumerate(normal.split()) if word != "0")
        sign = int(normal.split()[axis])
        point = " ".join(f"{-sign * half:.9g}" if d == axis else "0" for d in range(3))
        moves = " ".join(("v_way" if sign > 0 else "v_away") if d == axis else "NULL" for d in range(3))
        walls.append(f"region {name} plane {point} {normal} side in move {moves} units box\n"
                     f"fix {name} all wall/gran/region granular {law} region {name} contacts")
        forces.append(f"compute {name} all reduce sum f_{name}[{2 + axis}]")
        columns.append(f"c_{name}")
    steps = int((arguments.start - arguments.to) / 2 / (arguments.speed * step)) + 1
    lines = [f"create_atoms 1 single {x:.12g} {y:.12g} {z:.12g}\nset atom {n} diameter {2 * radius:.12g}"
             for n, (x, y, z, radius) in enumerate(spheres, 1)]
    return DECK.format(room=half + most, spheres="\n".join(lines), density=DENSITY, law=law, skin=0.3 * least, step=step, speed=arguments.speed,
                       walls="\n".join(walls), forces="\n".join(forces), columns=" ".join(columns), every=max(1, steps // 50), steps=steps)


def rows_of(text):
    """Rows of numbers below LAMMPS's last heading."""
    rows, inside = [], False
    for line in text.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            rows, inside = [], True
        elif inside and len(words) == 2 + len(WALLS) and words[0].isdigit():
            rows.append([float(word) for word in words[1:]])
        elif inside:
            inside = False
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("spheres", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path, nargs="?")
    parser.add_argument("--new", type=int, metavar="SEED")
    parser.add_argument("--from", dest="start", type=float, default=EDGE, help="edge of the box at the start")
    parser.add_argument("--to", type=float, default=2.002, help="at the end")
    parser.add_argument("--speed", type=float, default=0.1, help="of every wall [m/s]")
    parser.add_argument("--friction", type=float, default=0.5)
    parser.add_argument("--confinement", type=float, default=0.5, help="the law's psi_b: how soon a confined grain is stiff")
    parser.add_argument("--damping", type=float, default=0.5, help="the law's last number")
    parser.add_argument("--damping-kind", default="none")
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    if arguments.new is not None:
        lines = ["x_m,y_m,z_m,radius_m"] + [",".join(f"{value:.9g}" for value in sphere) for sphere in drawn(arguments.new)]
        deck_tables.write(lines, arguments.spheres)
        return
    program = shutil.which("lmp") or shutil.which("lmp_stable")
    if program is None:
        sys.exit("lmp is not here: Debian 13's package lammps")
    if arguments.folder is None:
        parser.error("FOLDER is missing")
    spheres = read_spheres(arguments.spheres)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    (arguments.folder / "in.spheres").write_text(deck(spheres, arguments), encoding="utf-8")
    done = subprocess.run([program, "-in", "in.spheres", "-log", "log"], cwd=arguments.folder, capture_output=True, text=True, check=False)
    rows = rows_of(done.stdout)
    if done.returncode != 0 or len(rows) < 2:
        sys.exit("\n".join((done.stdout + done.stderr).splitlines()[-15:]))
    volume = sum(4 / 3 * math.pi * radius**3 for *_, radius in spheres)
    lines = ["time_s,edge_m,packing_fraction,stress_xx_Pa,stress_yy_Pa,stress_zz_Pa"]
    for way, *walls in rows:
        edge = arguments.start - 2 * way
        stress = [0.5 * (walls[2 * d] - walls[2 * d + 1]) / edge**2 for d in range(3)]
        lines.append(",".join(f"{value:.9g}" for value in (way / arguments.speed, edge, volume / edge**3, *stress)))
    deck_tables.write(lines, arguments.out)


if __name__ == "__main__":
    main()
