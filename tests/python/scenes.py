# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Scenes built in Python: names and values are those of the program, the file is what a hand would write, the examples run. Arguments:
see common.py.
"""

import glob
import importlib
import os
import sys
import unittest
from unittest import mock

import common
import numpy as np
import softgrain
from softgrain.made_by import entries_of

ROOT = os.path.abspath(os.path.join(common.PYTHON, os.pardir))
sys.path.insert(0, os.path.join(ROOT, "examples"))
WRITTEN = """# Two disks
# and a wall that swings.

set Fidelity = draft

subsection Materials
  set Names = gel, stone
  subsection gel
    set Law     = gent
    set Density = 990
    subsection Gent
      set Young's modulus = 1e6
      set Locking         = 30
    end
  end
  subsection stone
    subsection Neo-Hookean
      set Poisson's ratio = 0.3
    end
  end
end

subsection Bodies
  set Names = lower, upper
  subsection lower
    set Material = stone
    set Center   = 2e-3, 2e-3
    set Radius   = 2e-3
  end
  subsection upper
    set Material = gel
    set Center   = 2e-3, 6e-3
    set Radius   = 2e-3
    set Velocity = 0; -0.1*cos(x)
  end
end

subsection Walls
  set Names = bottom, top, left, right
  subsection bottom
    set Point = 0, 0
  end
  subsection top
    set Point    = 0, 8e-3
    set Velocity = sin(t)
  end
  subsection left
    set Point = -2e-3, 0
  end
  subsection right
    set Point = 6e-3, 0
  end
end

subsection Obstacles
  set Names = ramp
  subsection ramp
    set Points = -1e-3, 0; -1e-3, 2e-3; 0, 3e-3
  end
end

subsection Contact
  set Friction of pairs = gel / stone: 0.2; gel / top: 0
end

subsection Stages
  set Names = press
  subsection press
    subsection Stop
      set Axial strain = 0.01
    end
    subsection top
      set Drive    = pressure
      set Pressure = 1000
    end
  end
end

subsection Mesh
  set Lower     = -2e-3, -1e-3
  set Upper     = 7e-3, 9e-3
  set Cell size = 5e-4
end
"""


def entries(path):
    return {name: text for name, (text, _) in entries_of(path).items()}


def two_disks():
    scene = softgrain.Scene()
    scene.title = "Two disks\nand a wall that swings."
    scene.fidelity = "draft"
    gel = scene.materials.add("gel", law="gent", density=990, youngs_modulus=1e6, locking=30)
    scene.materials.add("stone").neo_hookean.poissons_ratio = 0.3
    scene.mesh(lower=(-2e-3, -1e-3), upper=np.array([7e-3, 9e-3]), cell_size=np.float64(5e-4))
    scene.bodies.add("lower", center=(2e-3, 2e-3), radius=2e-3, material=scene.materials["stone"])
    scene.bodies.add("upper", center=(2e-3, 6e-3), radius=2e-3, material=gel, velocity=("0", "-0.1*cos(x)"))
    scene.walls(bottom={"point": (0, 0)}, top={"point": (0, 8e-3), "velocity": "sin(t)"}, left={"point": (-2e-3, 0)})
    scene.walls.add("right", point=(6e-3, 0))
    scene.obstacles.add("ramp", points=[(-1e-3, 0), (-1e-3, 2e-3), (0, 3 * 0.1e-2)])
    scene.contact.friction_of_pairs = {(gel, "stone"): 0.2, ("gel", "top"): 0}
    scene.stages.add("press", stop={"axial_strain": 0.01}, top={"drive": "pressure"})
    scene.stages.press.top.pressure = 1e3
    return scene


class Scenes(unittest.TestCase):
    def test_what_a_hand_would_write(self):
        self.assertEqual(two_disks().text, WRITTEN)

    def test_checked_as_a_file_is(self):
        """By the program: a file that it refuses is not written, and its lines name the parameter."""
        scene = two_disks()
        scene.contact.friction = -1
        scene.output.fields_every = "often"
        with self.assertRaisesRegex(softgrain.InputError, "^'Output/Fields every' = 'often' is not allowed: .*; 'Contact/Friction' = '-1'"):
            scene.write("refused.prm")
        self.assertEqual(glob.glob("*refused*") + glob.glob(".check*"), [])
        scene.contact.friction = scene.output.fields_every = None  # as it was
        self.assertIn("material points", scene.check())
        self.assertEqual(entries(scene.write("scenes/good.prm", check=False)), entries(write("hand.prm", WRITTEN)))

    def test_names(self):
        scene = two_disks()
        for name, call in (("'Contact' has no 'frction'; did you mean 'friction'?", lambda: setattr(scene.contact, "frction", 1)),
                           ("'Walls/new' has no 'pont'; did you mean 'point'?", lambda: scene.walls.add("new", pont=(0, 0))),
                           ("a scene has no 'msh'; did you mean 'mesh'?", lambda: scene.msh),
                           ("has no 'yield_stress'", lambda: scene.materials.gel.yield_stress),  # of another law
                           ("'Walls' has no 'side'; there are bottom, top", lambda: scene.walls["side"]),
                           ("'Stages/press' has no 'side'", lambda: scene.stages.press.side),
                           ("'Contact' has no 'Frction'; did you mean 'Friction'?", lambda: scene["Contact/Frction"]),
                           ("'Walls/top' is there already", lambda: scene.walls.add("top")),
                           ("'Mesh' is a section", lambda: setattr(scene, "mesh", 3)),
                           (r"say Scene\('bpm'\)", lambda: setattr(scene, "model", "bpm"))):
            with self.assertRaisesRegex(softgrain.InputError, name):
                call()
        self.assertEqual(scene.text, WRITTEN)
        self.assertEqual((scene.materials.gel.poissons_ratio, scene["Contact/Solver"], scene["Walls/Names"]), ("0.45", "condensed", "bottom, top, left, right"))
        self.assertIn("Coefficient of friction", scene.contact.help("friction"))
        self.assertIn("friction_of_pairs", dir(scene.contact))
        other = scene.copy()
        other["Walls/side/Point"] = (1e-3, 0)
        self.assertEqual((list(other.walls), list(scene.walls)), (["bottom", "top", "left", "right", "side"], ["bottom", "top", "left", "right"]))

    def test_shipped_scenes(self):
        """Every scene that is shipped can be read and written again, and says the same."""
        paths = sorted(path for path in glob.glob(os.path.join(ROOT, "parameters/*/*.prm")) if "/studies/" not in path)
        self.assertGreater(len(paths), 35)
        for path in paths:
            written = entries(write("again.prm", softgrain.Scene.read(path).text))
            self.assertEqual(written, entries(path), path)

    def test_in_space(self):
        """A scene in space has the shapes of space."""
        scene = softgrain.Scene("mpm", dimension=3)
        scene.materials.add("gel", youngs_modulus=1e5)
        scene.bodies.add("egg", shape="ellipsoid", center=(0, 0, 5e-3), semi_axes=(4e-3, 4e-3, 5e-3), rotation=(0, 0, 30))
        scene.walls.add("top", point=(0, 0, 10e-3), velocity=1e-3)
        scene.walls.add("bottom")
        scene.mesh(lower=(-5e-3, -5e-3, -1e-3), upper=(5e-3, 5e-3, 11e-3), cell_size=1.8e-3)
        scene.time(scheme="quasi_static", wall_way=0.1)
        scene.stop.end_time = 0.2
        run = scene.run("table/egg")
        self.assertEqual((run.parameters["Dimension"], run.summary["bodies"]), (3, 1))
        self.assertEqual(entries(write("egg.prm", softgrain.Scene.read("table/egg.prm").text)), entries("table/egg.prm"))
        for said, call in ((r"say Scene\(dimension=2\)", lambda: setattr(scene, "dimension", 2)),
                           ("has no 'semi_axes_'|has no 'angle'", lambda: scene.bodies.egg.angle)):
            with self.assertRaisesRegex(softgrain.InputError, said):
                call()

    def test_grains(self):
        """Disks at places of one's own are a table beside the file."""
        scene = softgrain.Scene("mpm")
        scene.materials.add("gel", youngs_modulus=1e5)
        scene.place([1e-3, 3.5e-3], 1e-3, [1e-3, 1.1e-3], "gel")
        scene.place(6e-3, 1.5e-3, 1.1e-3, "gel")
        scene.mesh(lower=(-1e-3, -1e-3), upper=(9e-3, 4e-3), cell_size=5e-4)
        scene.stop.end_time = 1e-4
        run = scene.run("table/three")
        self.assertEqual(np.round(run.parameters["Stop/End time"], 9), 1e-4)
        self.assertEqual(softgrain.read_table("table/three_grains.csv")["radius_m"].tolist(), [1e-3, 1.1e-3, 1.1e-3])
        self.assertEqual(run.summary["bodies"], 3)
        other = scene.copy()
        other.packing.file = "grains.csv"
        for said, call in (("is another packing: leave one out", lambda: other.write("twice.prm", check=False)),
                           ("arrays of one length", lambda: other.place([1, 2, 3], [1, 2], 1))):
            with self.assertRaisesRegex(softgrain.InputError, said):
                call()
        # The same again is there; with other grains it is another run.
        self.assertIsNone(scene.run("table/three", again=False).log)
        scene.place(1e-3, 3e-3, 0.5e-3, "gel")
        with self.assertRaisesRegex(softgrain.InputError, "another content of .*three_grains.csv"):
            softgrain.run(scene, output="table/three", again=False)


class Examples(unittest.TestCase):
    """Those of the folder examples, with fewer grains and an early end."""

    def test_bidisperse_mixture(self):
        module = importlib.import_module("bidisperse_mixture")
        run = module.mixture(seed=2, number=16, packing_fraction=0.6).run("mixture")
        self.assertEqual(run.summary["bodies"], 16)
        table = softgrain.read_table("mixture_grains.csv")
        self.assertEqual([int(np.sum(table["radius_m"] == radius)) for radius in (module.SMALL, module.LARGE)], [8, 8])
        self.assertGreaterEqual(run.history_table.packing_fraction[-1], 0.6)
        module.draw([run]).savefig("mixture.png")

    def test_hopper(self):
        module = importlib.import_module("hopper")
        run = module.hopper(3, number=6, end=0.14).run("hopper")
        times, below = module.fallen(run)
        self.assertEqual((below[0], len(times)), (0, len(run)))
        self.assertGreater(below[-1], 0)
        module.draw({3: run}).savefig("hopper.png")

    def test_shaken_box(self):
        """The floor lifts the disks and lets them fall; what relaxes is dissipated."""
        module = importlib.import_module("shaken_box")
        run = module.box(0.5, number=2, end=0.09).run("shaken")
        times, height = module.heights(run)
        self.assertEqual((len(times), int(height.argmin() > 5)), (len(run), 1))
        self.assertGreater(height[-1], 1e-3)
        self.assertGreater(run.history_table.dissipated_energy[-1], 0)
        module.draw({0.5: run}).savefig("shaken.png")

    def test_hard_and_soft(self):
        """Hard disks are strained less than soft ones."""
        module = importlib.import_module("hard_and_soft")
        run = module.mixture(10, side=4, packing_fraction=0.85).run("hard_and_soft")
        kinds = softgrain.read_table("hard_and_soft_grains.csv")["material"]
        self.assertEqual([int(np.sum(kinds == kind)) for kind in ("hard", "soft")], [8, 8])
        packing, hard, soft = module.shares(run)
        self.assertAlmostEqual(packing[-1], run.history_table.packing_fraction[-1])
        points = run[-1].points
        strains = [points.equivalent_strain[kinds[points.body] == kind].mean() for kind in ("hard", "soft")]
        self.assertLess(strains[0], 0.3 * strains[1])
        self.assertTrue(min(hard[-1], soft[-1]) > 0)
        module.draw({10: run}).savefig("hard_and_soft.png")

    def test_modulus(self):
        """Finer cells are nearer to the finest, and the study says which suffice."""
        module = importlib.import_module("modulus")
        with mock.patch.object(softgrain.study, "MOST_CHECKS", 0.):
            found = module.study("modulus", cells=(3, 5), finest=8, strains=(0.05, 0.1))
        coarse, fine = (one.differences["force"].error for one in found.results[:2])
        self.assertTrue(0 < fine < coarse < 0.05, (fine, coarse))
        module.draw(found).savefig("modulus.png")

    def test_oscillating_wall(self):
        """The loss tangent of Maxwell's law, within a hundredth."""
        module = importlib.import_module("oscillating_wall")
        runs = {3: module.block(3, cycles=3).run("swing")}
        self.assertAlmostEqual(module.loss(runs[3], 3) / module.expected(3), 1, delta=0.01)
        module.draw(runs).savefig("swing.png")


def write(path, text):
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
