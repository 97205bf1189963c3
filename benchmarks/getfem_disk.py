#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk between two or four plates by GetFEM (Debian's python3-getfem): the rival's deck of doc/results/rivals.md.

    getfem_disk.py [--plates 4] [--rings 12,13] [--steps 20] [--law ciarlet] [--fine 0.004] [--out TABLE]

Without --fine the whole disk of bilinear quadrilaterals, a multiplier for the pressure, plates that approach by --to radii in --steps
equal steps. With --fine a quarter of it by triangles of quadratic displacement, of that size at the contacts: the reference. The table has the
way of a plate over the radius, and the force on a plate over E R.
"""
import argparse
import math
import pathlib
import sys

import deck_tables
import getfem
import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "contrib/results"))

POISSON = 0.45
MU = 0.5 / (1 + POISSON)
LAMBDA = POISSON / (1 + POISSON) / (1 - 2 * POISSON)
# Derivative of the volumetric energy by log J: that of softgrain's neo_hookean, and that of its mooney_rivlin with no second invariant.
PRESSURE = {"neo_hookean": "lambda*log(Det({0}))", "ciarlet": "lambda/2*(sqr(Det({0}))-1)"}
NEAR = 0.8  # radii from the middle of a contact within which its elements are small, all that touches at the end
LIGHT = (0.0025, 0.005, 0.01, 0.02, 0.03, 0.05)  # ways at which errors are asked for, beside the even ones


def whole_disk(rings):
    """Quadrilaterals of the unit disk: a square of rings[0] cells in each quarter, rings[1] layers around."""
    return getfem.Mesh("import", "structured_ball", "GT='GT_QK(2,1)';ORG=[0,0];SIZES=[1];"
                       f"NSUBDIV=[{rings[0]},{rings[1]}];SYMMETRIZED=0")


def quarter(fine, plates):
    """Triangles of the upper right quarter, small where plates meet it."""
    from contact_pressure import quarter_of_disk
    places, triangles = quarter_of_disk(fine, near=NEAR, both=plates == 4)
    grid = getfem.Mesh("empty", 2)
    kind = getfem.GeoTrans("GT_PK(2,1)")
    for corners in triangles:
        grid.add_convex(kind, places[corners].T)
    return grid


def sides_of(grid, whole, plates):
    """Faces that may touch: {(axis, sign): [(cell, face)]}; of a quarter also those on its axes, under the names 0 and 1."""
    found = {}
    for cell, face in grid.outer_faces().T:
        normal = grid.normal_of_face(cell, face)
        if not whole and normal.min() < -1 + 1e-9:
            found.setdefault(int(normal.argmin()), []).append((cell, face))
            continue
        for axis in (1, 0)[:plates // 2]:
            if abs(normal[axis]) > 0.6:
                found.setdefault((axis, 1 if normal[axis] > 0 else -1), []).append((cell, face))
    return found


class Disk:
    """The problem: displacement u, a pressure on each part of the outline that may touch, and the place of the plates."""

    def __init__(self, grid, whole, plates, law, degree):
        quads = degree == 1
        self.model = getfem.Model("real")
        displacement, pressure = getfem.MeshFem(grid, 2), getfem.MeshFem(grid, 1)
        displacement.set_fem(getfem.Fem("FEM_QK(2,1)" if quads else "FEM_PK(2,2)"))
        pressure.set_fem(getfem.Fem("FEM_QK(2,1)" if quads else "FEM_PK(2,1)"))
        self.rule = getfem.MeshIm(grid, getfem.Integ("IM_GAUSS_PARALLELEPIPED(2,4)" if quads else "IM_TRIANGLE(6)"))
        self.model.add_fem_variable("u", displacement)
        for name, value in (("mu", MU), ("lambda", LAMBDA), ("plate", 1.), ("r", 10.)):
            self.model.add_initialized_data(name, value)
        gradient = "(Id(2)+Grad_u)"
        stress = f"mu*({gradient}-Inv({gradient})')+{PRESSURE[law].format(gradient)}*Inv({gradient})'"
        self.model.add_nonlinear_term(self.rule, f"({stress}):Grad_Test_u")
        self.pressures = []
        for number, (side, faces) in enumerate(sides_of(grid, whole, plates).items(), 1):
            grid.set_region(number, np.array(faces).T)
            if isinstance(side, tuple):
                self.touch(number, pressure, side)
            else:
                self.model.add_linear_term(self.rule, f"1e5*u({side + 1})*Test_u({side + 1})", number)
        self.share = 1 if whole else 2
        if whole:
            self.hold(grid, plates)

    def touch(self, region, space, side):
        """The plate of a side: a multiplier p >= 0 for the gap to it."""
        (axis, sign), name = side, f"p{region}"
        self.model.add_filtered_fem_variable(name, space, region)
        component = f"({axis + 1})"
        gap = f"(({sign})*(X{component}+u{component})-plate)"
        self.model.add_nonlinear_term(
            self.rule, f"({sign})*{name}*Test_u{component}+({name}-pos_part({name}+r*{gap}))/r*Test_{name}", region)
        self.pressures.append((name, region, side))

    def hold(self, grid, plates):
        """Holds the middle: nothing else keeps the disk from moving and turning between smooth plates."""
        space = self.model.mesh_fem_of_variable("u")
        places = space.basic_dof_nodes()
        middle = np.flatnonzero(np.abs(places).max(0) < 1e-9)
        above = np.flatnonzero((np.abs(places[0]) < 1e-9) & (np.abs(places[1] - 1) < 1e-9))
        for row, dof in enumerate([*middle[:2], above[0]]):
            matrix = getfem.Spmat("empty", 1, space.nbdof())
            matrix.add(0, int(dof), 1.)
            self.model.add_constraint_with_penalization("u", 1e5, matrix, [0.])

    def force(self):
        """On the upper plate, over E R."""
        name, region = next((name, region) for name, region, side in self.pressures if side == (1, 1))
        return self.share * float(np.ravel(getfem.asm("generic", self.rule, 0, name, region, self.model))[0])

    def press(self, ways):
        """Force at each way of the plates."""
        for way in ways:
            self.model.set_variable("plate", [1. - way])
            iterations = self.model.solve("max_iter", 60, "max_res", 1e-9, "lsearch", "simplest", "alpha min", 0.01)[0]
            yield way, self.force(), iterations


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plates", type=int, choices=(2, 4), default=2)
    parser.add_argument("--rings", default="12,13", help="cells of the middle square of a quarter, layers around it")
    parser.add_argument("--steps", type=int, default=20)
    parser.add_argument("--to", type=float, default=0.3, help="way of a plate over the radius")
    parser.add_argument("--law", choices=sorted(PRESSURE), default="neo_hookean")
    parser.add_argument("--light", action="store_true", help="also stop at the small ways of the table of errors")
    parser.add_argument("--fine", type=float, help="the reference: a quarter, elements of this size at the contacts")
    parser.add_argument("--out", type=pathlib.Path)
    arguments = parser.parse_args()
    whole = arguments.fine is None
    getfem.util_trace_level(1)
    grid = whole_disk(arguments.rings.split(",")) if whole else quarter(arguments.fine, arguments.plates)
    ways = set(np.linspace(0, arguments.to, arguments.steps + 1)[1:].round(12))
    if arguments.light:
        ways |= {way for way in LIGHT if way < arguments.to}
    disk = Disk(grid, whole, arguments.plates, arguments.law, 1 if whole else 2)
    lines = ["way_over_R,force_over_E_R,iterations"]
    lines += [f"{way:.6g},{force:.9g},{iterations}" for way, force, iterations in disk.press(sorted(ways))]
    if not arguments.out:
        lines.insert(0, f"# {grid.nbcvs()} elements")
    deck_tables.write(lines, arguments.out)


if __name__ == "__main__":
    main()
