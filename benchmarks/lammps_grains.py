#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Disks that are pressed together in a box, as springs by LAMMPS (Debian's lammps): the rival's deck of doc/results/rivals.md.

    lammps_grains.py PACKING FOLDER [--height 10.6e-3] [--speed 0.2] [--to 8.13e-3] [--stiffness 0.323] [--out TABLE]

PACKING is a table x_m,y_m,radius_m. Disks overlap, and a spring turns the overlap into a force; the stiffness is that of softgrain's
one disk at d/R = 0.02, over E; a wall is twice as stiff, since only one body is dented. The table has height and force of the wall.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys

import deck_tables

YOUNG, DENSITY = 10e6, 990.

DECK = """units si
dimension 2
atom_style sphere
boundary f f p
newton off
comm_modify vel yes
region box block {left:.9g} {right:.9g} {low:.9g} {high:.9g} -{thick:.9g} {thick:.9g}
create_box 1 box
{grains}
set type 1 density/disc {density}
pair_style gran/hooke {pair:.9g} NULL {damping:.9g} NULL {friction} {tangential}
pair_coeff * *
neighbor {skin:.9g} bin
neigh_modify delay 0 every 1
timestep {step:.9g}
variable above equal "{height:.9g} - {speed}*step*dt"
compute radius all property/atom radius
variable fx atom "{wall:.9g}*((c_radius-x)*(c_radius>x) - (x+c_radius-{width:.9g})*(x+c_radius>{width:.9g}))"
variable up atom "{wall:.9g}*(c_radius-y)*(c_radius>y)"
variable down atom "-{wall:.9g}*(y+c_radius-v_above)*(y+c_radius>v_above)"
variable fy atom "v_up+v_down"
compute bottom all reduce sum v_up
compute top all reduce sum v_down
fix walls all addforce v_fx v_fy 0
fix drag all viscous {drag:.9g}
fix flat all enforce2d
fix time all nve/sphere disc
variable force equal "0.5*(c_bottom-c_top)"
thermo {every}
thermo_style custom step v_above v_force c_bottom c_top
thermo_modify lost error norm no
run {steps}
"""


def deck(grains, arguments):
    """The text of the input file."""
    least = min(radius for _, _, radius in grains)
    most = max(radius for _, _, radius in grains)
    mass = DENSITY * 3.141592653589793 * least**2
    pair = arguments.stiffness * YOUNG
    step = arguments.step_fraction * (mass / (2 * pair))**0.5
    damping = arguments.damping * (2 * pair / mass)**0.5
    lines = [f"create_atoms 1 single {x:.12g} {y:.12g} 0\nset atom {n} diameter {2 * radius:.12g}"
             for n, (x, y, radius) in enumerate(grains, 1)]
    steps = int((arguments.height - arguments.to) / (arguments.speed * step)) + 1
    return DECK.format(left=-most, right=arguments.width + most, low=-most, high=arguments.height + most, thick=most, grains="\n".join(lines),
                       density=DENSITY, pair=pair, wall=2 * pair, damping=damping, friction=arguments.friction,
                       tangential=1 if arguments.friction else 0, skin=0.3 * least, step=step, height=arguments.height,
                       speed=arguments.speed, width=arguments.width, drag=0.05 * damping * mass, every=max(1, steps // 400), steps=steps)


def table(text):
    """Rows of numbers below LAMMPS's heading of the walls."""
    inside = False
    for line in text.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            inside = True
        elif inside and len(words) == 5:
            yield [float(word) for word in words[1:]]
        elif inside:
            return


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packing", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--width", type=float, default=10e-3)
    parser.add_argument("--height", type=float, default=10.6e-3)
    parser.add_argument("--to", type=float, default=8.13e-3, help="height of the wall at the end")
    parser.add_argument("--speed", type=float, default=0.2)
    parser.add_argument("--friction", type=float, default=0.)
    parser.add_argument("--stiffness", type=float, default=0.323, help="force between two disks per overlap, over E")
    parser.add_argument("--step-fraction", type=float, default=0.05, help="of the square root of mass over stiffness")
    parser.add_argument("--damping", type=float, default=0.5, help="between disks, in the same unit")
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    program = shutil.which("lmp") or shutil.which("lmp_stable")
    if program is None:
        sys.exit("lmp is not here: Debian's package lammps")
    grains = deck_tables.read_grains(arguments.packing)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    (arguments.folder / "in.grains").write_text(deck(grains, arguments), encoding="utf-8")
    done = subprocess.run([program, "-in", "in.grains", "-log", "log"], cwd=arguments.folder, capture_output=True, text=True, check=False)
    rows = list(table(done.stdout))
    if done.returncode != 0 or not rows:
        sys.exit("\n".join((done.stdout + done.stderr).splitlines()[-15:]))
    lines = ["height_m,force_N_per_m,bottom_N_per_m,top_N_per_m"]
    lines += [",".join(f"{value:.9g}" for value in row[:3]) + f",{-row[3]:.9g}" for row in rows]
    deck_tables.write(lines, arguments.out)


if __name__ == "__main__":
    main()
