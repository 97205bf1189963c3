#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pressure along the contact of a disk with a plate against finite elements: the table of doc/results/contact-geometry.md.

    contact_pressure.py PROGRAM FOLDER [--fine 0.004]

The disk of verification/line_contact.prm is computed by GetFEM (Debian's python3-getfem) as well: a quarter of it, triangles with
quadratic displacement, the same law, at the contact a multiplier for the pressure, elements of --fine radii there.
"""
import argparse
import math
import pathlib

import numpy as np
from running import run, softgrain
from subgrid import CUTS, RADIUS, mesh

WAYS = (0.03, 0.06, 0.1)  # of a plate over the radius
SPACINGS = (0.058, 0.029)  # of points over the radius; a cell is twice that
POISSON = 0.45
EDGE = 0.92  # of the half width, up to which pressures are compared


def quarter_of_disk(fine, coarse=0.08, near=0.35, growth=0.16, both=False):
    """Vertices and triangles of a quarter of the unit disk, small near its top, and with @both at its right end, too."""
    from scipy.spatial import Delaunay

    def size_at(x, y):
        away = math.hypot(max(0., x - near), 1 - y)
        if both:
            away = min(away, math.hypot(max(0., y - near), 1 - x))
        return min(coarse, max(fine, growth * away))

    angles = [0.]
    while angles[-1] < math.pi / 2:
        angles.append(angles[-1] + size_at(math.sin(angles[-1]), math.cos(angles[-1])))
    angles = np.array(angles) * (math.pi / 2 / angles[-1])
    smallest, waiting = {}, [(0., 0., 1.)]
    while waiting:
        x, y, width = waiting.pop()
        if width > 1.2 * size_at(x + width / 2, y + width / 2):
            waiting += [(x + i * width / 2, y + j * width / 2, width / 2) for i in (0, 1) for j in (0, 1)]
            continue
        for corner in ((x, y), (x + width, y), (x, y + width), (x + width, y + width)):
            smallest[corner] = min(smallest.get(corner, 1.), width)
    inside = [corner for corner, width in smallest.items() if math.hypot(*corner) < 1 - 0.6 * width]
    places = np.array(sorted({(round(x, 14), round(y, 14)) for x, y in [*inside, *zip(np.sin(angles), np.cos(angles))]}))
    triangles = Delaunay(places).simplices
    one, other = (places[triangles[:, i]] - places[triangles[:, 0]] for i in (1, 2))
    return places, triangles[np.abs(one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0]) > 1e-12]


def finite_elements(fine):
    """{way: (force over E R, places over R, pressure over E)} of half a contact, from its middle on."""
    import getfem
    places, triangles = quarter_of_disk(fine)
    grid = getfem.Mesh("empty", 2)
    kind = getfem.GeoTrans("GT_PK(2,1)")
    for corners in triangles:
        grid.add_convex(kind, places[corners].T)
    sides = {1: [], 2: [], 3: []}
    for cell, face in grid.outer_faces().T:
        x, y = grid.normal_of_face(cell, face)
        side = 1 if x < -1 + 1e-9 else 2 if y < -1 + 1e-9 else 3 if y > 0.8 else 0
        if side:
            sides[side].append((cell, face))
    for side, faces in sides.items():
        grid.set_region(side, np.array(faces).T)
    displacement, pressure = getfem.MeshFem(grid, 2), getfem.MeshFem(grid, 1)
    displacement.set_fem(getfem.Fem("FEM_PK(2,2)"))
    pressure.set_fem(getfem.Fem("FEM_PK(2,1)"))
    rule = getfem.MeshIm(grid, getfem.Integ("IM_TRIANGLE(6)"))
    model = getfem.Model("real")
    model.add_fem_variable("u", displacement)
    model.add_filtered_fem_variable("p", pressure, 3)
    for name, value in (("mu", 0.5 / (1 + POISSON)), ("lambda", POISSON / (1 + POISSON) / (1 - 2 * POISSON)), ("plate", 1.), ("r", 0.1 / fine)):
        model.add_initialized_data(name, value)
    gradient = "(Id(2)+Grad_u)"
    model.add_nonlinear_term(rule, f"(mu*({gradient}-Inv({gradient})')+lambda*log(Det({gradient}))*Inv({gradient})'):Grad_Test_u")
    model.add_nonlinear_term(rule, "p*Test_u(2)+(p-pos_part(p+r*(X(2)+u(2)-plate)))/r*Test_p", 3)
    for side in (1, 2):
        model.add_linear_term(rule, f"1e5*u({side})*Test_u({side})", side)
    found, before = {}, 0.
    nodes = pressure.basic_dof_on_region(3)
    at = pressure.basic_dof_nodes(nodes)
    nodes, at = nodes[np.argsort(at[0])], at[:, np.argsort(at[0])]
    for way in WAYS:
        for step in np.linspace(before, way, math.ceil((way - before) / 0.005) + 1)[1:]:
            model.set_variable("plate", [1. - step])
            model.solve("max_iter", 60, "max_res", 1e-9, "lsearch", "simplest", "alpha min", 0.01)
        before = way
        moved = np.asarray(getfem.compute(displacement, model.variable("u"), "interpolate on", pressure)).reshape(2, -1, order="F")[:, nodes]
        nominal = np.asarray(getfem.compute(model.mesh_fem_of_variable("p"), model.variable("p"), "interpolate on", pressure)).ravel()[nodes]
        force = 2 * float(np.ravel(getfem.asm("generic", rule, 0, "p", 3, model))[0])
        along = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(at)))])
        found[way] = force, at[0] + moved[0], nominal / np.gradient(at[0] + moved[0], along)
    return found


def half_width_of(force, places, pressure):
    """Of the half ellipse with the same second moment."""
    return 2 * math.sqrt(2 * np.trapz(pressure * places**2, places) / force)


def compare(program, folder, spacing, cut, exact):
    """Of each way of the plates: force, half width and largest difference of the pressure, over those of finite elements."""
    changes = {**mesh(2 * spacing * RADIUS, cut), "Time/Time step": 5e-3, "Stop/End time": max(WAYS), "Output/Snapshots every": 0.01}
    _, rows = run(program, "verification/line_contact.prm", folder, changes, threads=1, again=False)
    young, result = 10e6, []
    for way in WAYS:
        state = min(softgrain.open(folder), key=lambda one: abs(one.time - way))
        assert abs(state.time - way) < 1e-9
        force, places, pressure = exact[way]
        profile = state.contact_profile("disk", "bottom")
        half, peak = half_width_of(force, places, pressure), pressure.max()
        inside = np.abs(profile["along_m"]) < EDGE * half * RADIUS
        off = profile["pressure_Pa"] / young - np.interp(np.abs(profile["along_m"]) / RADIUS, places, pressure)
        result.append((float(profile["pressure_Pa"] @ profile["length_m"]) / (young * RADIUS) / force - 1,
                       profile.half_width_m / RADIUS / half - 1, float(np.abs(off[inside]).max() / peak),
                       half * RADIUS / (2 * spacing * RADIUS), profile.width_from))
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--fine", type=float, default=0.004)
    arguments = parser.parse_args()
    exact = finite_elements(arguments.fine)
    for way, (force, places, pressure) in exact.items():
        print(f"finite elements, d/R = {way}: F/ER {force:.5f}, half width / R {half_width_of(force, places, pressure):.4f}, "
              f"peak / E {pressure.max():.4f}", flush=True)
    print("| cells in R | d/R | half width, cells | from | force | half width | pressure |\n|---|---|---|---|---|---|---|")
    for spacing in SPACINGS:
        found = [compare(arguments.program, arguments.folder / f"{spacing}-{cut}", spacing, cut, exact) for cut in CUTS]
        for n, way in enumerate(WAYS):
            of_cuts = [one[n] for one in found]
            ends = [f"{100 * min(one[k] for one in of_cuts):+.1f} … {100 * max(one[k] for one in of_cuts):+.1f}" for k in (0, 1)]
            print(f"| {0.5 / spacing:.1f} | {way} | {of_cuts[0][3]:.1f} | {of_cuts[0][4]} | {ends[0]} | {ends[1]} | "
                  f"{', '.join(f'{100 * one[2]:.1f}' for one in of_cuts)} |", flush=True)


if __name__ == "__main__":
    main()
