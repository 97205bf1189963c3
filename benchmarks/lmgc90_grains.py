#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Soft disks that are pressed together in a box by LMGC90, for whoever has its module pylmgc90: no registry has it, so this deck was
never run where doc/results/rivals.md was written.

    lmgc90_grains.py PACKING FOLDER [--speed 0.2] [--step 1e-5] [--theta 0.7] [--rings 3,3]

PACKING is a table x_m,y_m,radius_m. Every disk is a mesh of bilinear quadrilaterals of softgrain's law. Walls are rigid; their forces are in
the files of FOLDER/POSTPRO (torque evolution), which LMGC90 writes.
"""
import argparse
import os
import pathlib

import deck_tables
import numpy as np
from calculix_disk import disk_mesh

YOUNG, POISSON, DENSITY = 10e6, 0.45, 990.


def grain(pre, model, material, x, y, radius, rings):
    """A meshed disk that may touch with all of its rim."""
    places, cells, rim = disk_mesh(*rings)
    grid = pre.mesh(dimension=2)
    for number, place in enumerate(places, 1):
        grid.addNode(pre.node(coor=np.array([x, y]) + radius * place, number=number))
    for cell in cells:
        grid.addBulk(pre.element(elem_dim=2, connectivity=[node + 1 for node in cell], physicalEntity="inside"))
    for one, next_one in zip(rim, rim[1:] + rim[:1]):
        grid.addBulk(pre.element(elem_dim=1, connectivity=[one + 1, next_one + 1], physicalEntity="rim"))
    body = pre.buildMeshedAvatar(mesh=grid, model=model, material=material)
    body.addContactors(group="rim", shape="CLxxx", color="GRAIN", weights=[0.5])
    body.addContactors(group="rim", shape="ALpxx", color="GRAIN")
    return body


def walls(pre, model, material, width, height, speed):
    """Bottom, top, left and right; the top one comes down."""
    thick = 0.02 * width
    made = []
    for x, y, along, across, down in ((width / 2, -thick, width, thick, 0.), (width / 2, height + thick, width, thick, -speed),
                                      (-thick, height / 2, thick, height, 0.), (width + thick, height / 2, thick, height, 0.)):
        flat = along > across
        wall = pre.rigidJonc(axe1=(along if flat else across) / 2 * 1.2, axe2=thick, center=[x, y], model=model, material=material, color="WALLx")
        if not flat:
            wall.rotate(psi=np.pi / 2, center=np.array([x, y]))
        wall.imposeDrivenDof(component=[1, 3], dofty="vlocy")
        wall.imposeDrivenDof(component=2, dofty="vlocy", ct=down)
        made.append(wall)
    return made


def prepare(grains, arguments):
    """Writes LMGC90's own input files below the present folder."""
    from pylmgc90 import pre
    os.makedirs("DATBOX", exist_ok=True)
    bodies, models, materials, tables, laws = pre.avatars(), pre.models(), pre.materials(), pre.see_tables(), pre.tact_behavs()
    soft = pre.model(name="softx", physics="MECAx", element="Q4xxx", dimension=2, external_model="MatL_", kinematic="large", formulation="TotaL",
                     material="neoh_", anisotropy="iso__", mass_storage="lump_")
    rigid = pre.model(name="rigid", physics="MECAx", element="Rxx2D", dimension=2)
    gel = pre.material(name="gelxx", materialType="ELAS", elas="standard", young=YOUNG, nu=POISSON, anisotropy="isotropic", density=DENSITY)
    steel = pre.material(name="steel", materialType="RIGID", density=7800.)
    models.addModel(soft)
    materials.addMaterial(gel, steel)
    for place in grains:
        bodies.addAvatar(grain(pre, soft, gel, *place, arguments.rings))
    box = walls(pre, rigid, steel, arguments.width, arguments.height, arguments.speed)
    for wall in box:
        bodies.addAvatar(wall)
    touch = pre.tact_behav(name="touch", law="GAP_SGR_CLB", fric=arguments.friction)
    laws.addBehav(touch)
    reach = 0.2 * min(radius for _, _, radius in grains)
    for body, partner, colour in (("MAILx", "ALpxx", "GRAIN"), ("RBDY2", "JONCx", "WALLx")):
        tables.addSeeTable(pre.see_table(CorpsCandidat="MAILx", candidat="CLxxx", colorCandidat="GRAIN", behav=touch, CorpsAntagoniste=body,
                                         antagoniste=partner, colorAntagoniste=colour, alert=reach, halo=2 * reach))
    post = pre.postpro_commands()
    post.addCommand(pre.postpro_command(name="TORQUE EVOLUTION", step=1, rigid_set=box))
    pre.writeDatbox(2, materials, models, bodies, laws, tables, post=post, gravy=[0., 0., 0.])


def compute(steps, arguments):
    """Newton's method around LMGC90's own loop over contacts."""
    from pylmgc90 import chipy
    chipy.Initialize()
    chipy.checkDirectories()
    chipy.SetDimension(2, 1)  # plane strain
    chipy.TimeEvolution_SetTimeStep(arguments.step)
    chipy.Integrator_InitTheta(arguments.theta)
    chipy.NewtonRaphson_SetFinalTime(steps * arguments.step)
    chipy.NewtonRaphson_SetMinTimeStep(arguments.step)
    chipy.NewtonRaphson_SetMaxTimeStep(arguments.step)
    chipy.NewtonRaphson_SetMaxIter(20)
    chipy.ReadDatbox(deformable=True)
    chipy.OpenPostproFiles()
    chipy.ComputeMass()
    for _ in range(steps):
        chipy.IncrementStep()
        chipy.ComputeFext()
        chipy.NewtonRaphson_Initialize(1e-6)
        tried, going_on = 0, 1
        while going_on == 1:
            tried += 1
            chipy.ComputeBulk()
            chipy.AssembleMechanicalRHS()
            chipy.AssembleMechanicalLHS()
            chipy.ComputeFreeVelocity()
            chipy.SelectProxTactors()
            chipy.RecupRloc()
            chipy.ExSolver("Stored_Delassus_Loops         ", "Quad ", 1e-5, 1., 200, 50)
            chipy.StockRloc()
            chipy.ComputeDof()
            if tried > 1:
                going_on = chipy.NewtonRaphson_CheckConvergence(chipy.mecaMAILx_ComputeResidueNorm())
        chipy.ComputeField()
        chipy.UpdateStep()
        chipy.WritePostproFiles()
    chipy.ClosePostproFiles()
    chipy.Finalize()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("packing", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--width", type=float, default=10e-3)
    parser.add_argument("--height", type=float, default=10.6e-3)
    parser.add_argument("--to", type=float, default=8.32e-3, help="height of the wall at the end")
    parser.add_argument("--speed", type=float, default=0.2)
    parser.add_argument("--friction", type=float, default=0.)
    parser.add_argument("--step", type=float, default=1e-5)
    parser.add_argument("--theta", type=float, default=0.7)
    parser.add_argument("--rings", type=lambda text: tuple(int(word) for word in text.split(",")), default=(3, 3),
                        help="half the cells across the middle square, layers around it: 3,3 are 108 quadrilaterals")
    arguments = parser.parse_args()
    try:
        import pylmgc90  # noqa: F401
    except ImportError:
        parser.exit(1, "pylmgc90 is not here: LMGC90 is in no registry, build it from its source\n")
    grains = deck_tables.read_grains(arguments.packing)
    arguments.folder.mkdir(parents=True, exist_ok=True)
    os.chdir(arguments.folder)
    prepare(grains, arguments)
    compute(round((arguments.height - arguments.to) / (arguments.speed * arguments.step)), arguments)


if __name__ == "__main__":
    main()
