#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Line contact of laws that flow, for doc/results/laws.md: where a disk between plates yields first, what a cylinder needs to
indent a plastic block, and how the contact of a Maxwell disk under constant load widens. Prints measured over expected."""
import argparse
import math
import pathlib

import numpy as np
from running import PARAMETERS, softgrain

E = 1e7


def disk(cells, size=2.6):
    """Changes of verification/line_contact.prm for a disk of 5 mm with so many cells over its radius."""
    h = 5e-3 / cells
    half = size / 2 * 5e-3
    return {"Mesh/Cell size": h, "Mesh/Lower": f"{-half}, {-5e-3 - 3 * h}", "Mesh/Upper": f"{half}, {5e-3 + 3 * h}",
            "Materials/gel/Linear elastic/Young's modulus": E, "Output/Number of field outputs": 0}


def go(words, name, changes, scene=PARAMETERS / "verification/line_contact.prm"):
    return softgrain.run(scene, set=changes, output=str(words.output / name), program=str(words.program), threads=words.threads,
                         again=False, overwrite=True)


def expected_yield(nu, slenderness):
    """p0 over the largest von Mises stress below the contact of a disk between plates, a/R = @slenderness; Johnson, Contact
    Mechanics, (5.57) and (5.58), with P = pi a p0 / 2."""
    a = slenderness
    z = np.linspace(1e-3, 3, 30000) * a
    root = np.sqrt(a * a + z * z)
    x = a / 2 * (1 - 2 * (a * a + 2 * z * z) / (a * a * root) + 4 * z / a**2)
    y = a / 2 * (1 - 2 / (2 - z) - 2 / root)
    out = nu * (x + y)
    return 1 / np.sqrt(((x - y) ** 2 + (y - out) ** 2 + (out - x) ** 2) / 2).max()


def first_yield(words):
    print("first yield: nu, a/R, p0 / largest von Mises stress, expected there (Johnson), in the limit of small a/R, ratio")
    for nu, limit in ((0.3, 1.7937), (0.45, 1.9143), (0.4999, 1.9227)):
        done = go(words, f"yield_{nu}", {
            **disk(words.cells), "Materials/gel/Law": "linear_elastic", "Materials/gel/Linear elastic/Poisson's ratio": nu,
            "Time/Time step": 2e-3, "Stop/End time": 0.012, "Output/Snapshots every": 2e-3, "Material points/F-bar": "on"})
        R, modulus = 5e-3, E / (1 - nu * nu)
        for state in list(done)[-3:]:
            wall = state.walls
            load = float(wall.normal_force[wall.name == "top"][0])
            p0, a = math.sqrt(load * modulus / math.pi / R), math.sqrt(4 * load * R / math.pi / modulus)
            points = state.points
            x, y = points.position_m[:, 0], points.position_m[:, 1]
            xx, yy, xy = points.stress_Pa.T
            zz = points.out_of_plane_stress_Pa
            mises = np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy**2)
            depth = float(wall.position_m[wall.name == "top"][0]) - y
            # The largest value on the axis of a parabola through the points below the contact, free of their scatter.
            near = (np.abs(x) < 0.25 * a) & (depth > 0.35 * a) & (depth < 1.3 * a)
            fit = np.linalg.lstsq(np.stack([x[near] ** 2 / a**2] + [(depth[near] / a) ** k for k in range(4)], axis=1), mises[near],
                                  rcond=None)[0]
            largest = np.polyval(fit[:0:-1], np.linspace(0.4, 1.2, 400)).max()
            there = expected_yield(nu, a / R)
            print(f"  {nu:6} {a / R:6.3f} {p0 / largest:7.4f} {there:7.4f} {limit:7.4f} {p0 / largest / there:7.4f}", flush=True)


BLOCK = """
subsection Mesh
  set Lower     = {left}, {bottom}
  set Upper     = {right}, {top}
  set Cell size = 1e-3
end
subsection Material points
  set F-bar = on
end
subsection Materials
  set Names = metal
  subsection metal
    set Density = 1000
    set Law     = j2_plastic
    subsection J2 plastic
      set Young's modulus   = 1e9
      set Poisson's ratio   = 0.3
      set Yield stress      = 1e6
      set Saturation stress = 1e6
    end
  end
end
subsection Bodies
  set Names = block
  subsection block
    set Shape  = rectangle
    set Center = 0, {middle}
    set Size   = {width}, {height}
  end
end
subsection Walls
  set Names = bottom
  subsection bottom
    set Point = 0, {floor}
  end
end
subsection Obstacles
  set Names = cylinder
  subsection cylinder
    set Shape        = arc
    set Center       = 0, 40.0001e-3
    set Radius       = 40e-3
    set From         = 225
    set To           = 315
    set Displacement = 0; -1e-3*t
  end
end
subsection Time
  set Scheme    = quasi_static
  set Time step = 0.02
end
subsection Stop
  set End time = 1.6
end
subsection Output
  set Snapshots every = 0.04
end
"""


def indentation(words):
    """A smooth cylinder of 40 cells' radius on a block of 60 x 36 cells, E / S_y = 1000."""
    scene = words.output / "indentation.prm"
    scene.parent.mkdir(parents=True, exist_ok=True)
    scene.write_text(BLOCK.format(left=-34e-3, right=34e-3, bottom=-39e-3, top=6e-3, middle=-18e-3, width=60e-3, height=36e-3,
                                  floor=-36e-3), encoding="utf-8")
    done = go(words, "indentation", {}, scene)
    print("indentation: a/R, mean pressure / S_y, expected 2.97 when fully plastic")
    for state in done:
        touching = state.contacts.where(state.contacts.body_b < 0)
        if len(touching) < 4:
            continue
        force, place = touching.force_N_per_m, touching.place_m
        width = float(touching.length_m.sum())
        load = float(force[:, 1].sum())
        print(f"  {width / 2 / 40e-3:6.3f} {-load / width / 1e6:7.3f}  extent {np.ptp(place[:, 0]) / 80e-3:6.3f}", flush=True)


def maxwell(words):
    """A disk with E(t) = E (0.4 + 0.6 exp(-t)) under a constant load: a^2 ~ J(t) = (1/0.4 - (1/0.4 - 1) exp(-0.4 t)) / E."""
    step, half = 0.05, 10e-3
    done = go(words, "maxwell", {
        **disk(words.cells_of_maxwell, 4.4), "Materials/gel/Law": "maxwell", "Materials/gel/Maxwell/Young's modulus": E,
        "Materials/gel/Maxwell/Poisson's ratio": 0.3, "Materials/gel/Maxwell/Shares": 0.6, "Materials/gel/Maxwell/Relaxation times": 1,
        "Walls/Names": "bottom, top, left, right", "Walls/bottom/Velocity": 0, "Walls/top/Drive": "pressure",
        "Walls/top/Velocity": 0, "Walls/top/Pressure": 3.5e-3 * E, "Walls/left/Point": f"{-half}, 0", "Walls/left/Normal": "1, 0",
        "Walls/right/Point": f"{half}, 0", "Walls/right/Normal": "-1, 0", "Time/Time step": step, "Stop/End time": 2,
        "Output/Snapshots every": 0.1})
    print("Maxwell disk under constant load: t, a/R, a^2 / expected")
    for state in done:
        touching = state.contacts.where(state.contacts.wall == 0)
        if len(touching) < 4:
            continue
        f, x = touching.force_N_per_m[:, 1], touching.place_m[:, 0]
        load = f.sum()
        middle = (f * x).sum() / load
        a2 = 4 * (f * (x - middle) ** 2).sum() / load  # of Hertz's pressure
        t = state.time - step / 2  # loaded within the first step
        J = (1 / 0.4 - (1 / 0.4 - 1) * math.exp(-0.4 * t)) / E
        print(f"  {state.time:5.2f} {math.sqrt(a2) / 5e-3:6.3f} {a2 / (4 * 5e-3 * load * (1 - 0.09) * J / math.pi):7.4f}", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("output/contact_of_laws"))
    parser.add_argument("--cells", type=int, default=50, help="over the radius, for first yield")
    parser.add_argument("--cells-of-maxwell", type=int, default=20)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--only", choices=("yield", "indentation", "maxwell"))
    words = parser.parse_args()
    for name, part in (("maxwell", maxwell), ("indentation", indentation), ("yield", first_yield)):
        if words.only in (None, name):
            part(words)


if __name__ == "__main__":
    main()
