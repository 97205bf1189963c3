#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A disk between two plates by NairnMPM, for whoever has it: no registry has it, so this deck was never run where doc/results/rivals.md was written.

    nairnmpm_disk.py PROGRAM FOLDER [--cell 0.29] [--speed 0.2] [--to 0.3]

Writes disk.fmcmd into FOLDER and runs PROGRAM there. The disk of parameters/thesis/diametral_compression_mpm.prm: radius 5 mm, a neo-Hookean
solid. The lower plate is fixed, and the upper one comes down until the logarithmic strain is --to.
"""
import argparse
import math
import pathlib
import subprocess
import sys

RADIUS, YOUNG, POISSON, DENSITY = 5., 10., 0.45, 0.99  # mm, MPa, g/cm^3: the units that NairnMPM takes

DECK = """<?xml version='1.0'?>
<!DOCTYPE JANFEAInput SYSTEM 'NairnMPM.dtd'>
<JANFEAInput version='3'>
  <Header><Description>A disk between two plates</Description><Analysis>10</Analysis></Header>
  <MPMHeader>
    <MaxTime units='ms'>{time:.6g}</MaxTime>
    <ArchiveTime units='ms'>{archive:.6g}</ArchiveTime>
    <ArchiveRoot>disk.</ArchiveRoot>
    <GlobalArchiveTime units='ms'>{archive:.6g}</GlobalArchiveTime>
    <GlobalArchive type='contacty' matname='plate'/>
    <MultiMaterialMode Vmin='0' Dcheck='0' Normals='0'><Friction>0</Friction></MultiMaterialMode>
    <GIMP/>
  </MPMHeader>
  <Mesh output='file'>
    <Grid xmin='-{half:.6g}' xmax='{half:.6g}' ymin='-{half:.6g}' ymax='{half:.6g}'>
      <Horiz cellsize='{cell:.6g}'/><Vert cellsize='{cell:.6g}'/>
    </Grid>
  </Mesh>
  <MaterialPoints>
    <Body matname='disk' angle='0' thick='1' vx='0' vy='0'><Oval xmin='-{r:.6g}' xmax='{r:.6g}' ymin='-{r:.6g}' ymax='{r:.6g}'/></Body>
    <Body matname='plate' angle='0' thick='1' vx='0' vy='-{speed:.6g}'><Rect xmin='-{wide:.6g}' xmax='{wide:.6g}' ymin='{r:.6g}' ymax='{high:.6g}'/></Body>
    <Body matname='base' angle='0' thick='1' vx='0' vy='0'><Rect xmin='-{wide:.6g}' xmax='{wide:.6g}' ymin='-{high:.6g}' ymax='-{r:.6g}'/></Body>
  </MaterialPoints>
  <Material Type='28' Name='disk'><rho>{density}</rho><E>{young}</E><nu>{poisson}</nu><UJOption>2</UJOption></Material>
  <Material Type='11' Name='plate'><SetDirection>8</SetDirection></Material>
  <Material Type='11' Name='base'><SetDirection>8</SetDirection></Material>
</JANFEAInput>
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path, help="NairnMPM")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--cell", type=float, default=0.29, help="[mm]")
    parser.add_argument("--speed", type=float, default=0.2, help="[m/s]")
    parser.add_argument("--to", type=float, default=0.3, help="logarithmic strain at the end")
    arguments = parser.parse_args()
    if not arguments.program.is_file():
        parser.exit(1, f"{arguments.program} is not there: NairnMPM is in no registry, build it from its source\n")
    arguments.folder.mkdir(parents=True, exist_ok=True)
    time = 2 * RADIUS * (1 - math.exp(-arguments.to)) / arguments.speed  # mm over m/s: ms
    half = arguments.cell * math.ceil(1.6 * RADIUS / arguments.cell)
    text = DECK.format(time=time, archive=time / 100, half=half, cell=arguments.cell, r=RADIUS, speed=1e3 * arguments.speed, wide=1.5 * RADIUS,
                       high=RADIUS + 4 * arguments.cell, density=DENSITY, young=YOUNG, poisson=POISSON)
    (arguments.folder / "disk.fmcmd").write_text(text, encoding="utf-8")
    sys.exit(subprocess.run([str(arguments.program.resolve()), "-v", "disk.fmcmd"], cwd=arguments.folder, check=False).returncode)


if __name__ == "__main__":
    main()
