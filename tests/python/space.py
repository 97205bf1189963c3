# SPDX-License-Identifier: LGPL-2.1-or-later
"""A short run in space: its arrays against measures.csv and against the other kind of file. Arguments: see common.py."""

import os
import subprocess
import sys
import unittest

import common
import matplotlib.image
import numpy as np
import softgrain
import tool_runs
from softgrain import raster
from softgrain.space_picture import cut_through

SCENE = """
set Dimension = 3
subsection Materials
  set Names = gel
  subsection gel
    set Law     = neo_hookean
    set Density = 1000
    subsection Neo-Hookean
      set Young's modulus = 1
      set Poisson's ratio = 0.4
    end
  end
end
subsection Packing
  set File = balls.csv
end
subsection Walls
  set Names = bottom, top, left, right, front, back
  subsection bottom
  end
  subsection top
    set Point    = 0, 0, 10
    set Velocity = 1
  end
  subsection left
    set Point = -2.8, 0, 0
  end
  subsection right
    set Point = 2.8, 0, 0
  end
  subsection front
    set Point = 0, -2.8, 0
  end
  subsection back
    set Point = 0, 2.8, 0
  end
end
subsection Mesh
  set Lower     = -6, -6, -1
  set Upper     = 6, 6, 11
  set Cell size = 1
end
subsection Time
  set Scheme   = quasi_static
  set Wall way = 0.3
end
subsection Stop
  set Axial strain = 0.15
end
subsection Output
  set Fields every    = 0.7
  set Snapshots every = 0.7
  set Measures        = all
end
"""
BALLS = "x_m,y_m,z_m,radius_m\n0.12,-0.08,2.4,2.3\n-0.21,0.13,7.3,2.5\n"


def place_of(seen, vertices, triangles):
    return (seen.weight[:, :, None] * vertices[triangles[seen.triangle]]).sum(axis=1)


class Space(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open("balls.csv", "w", encoding="utf-8") as file:
            file.write(BALLS)
        with open("two.prm", "w", encoding="utf-8") as file:
            file.write(SCENE)
        subprocess.run([common.PROGRAM, "run", "two.prm", "--threads", "1", "--output", "out"], check=True,
                       stdout=subprocess.DEVNULL)
        cls.found = softgrain.open("out")

    def test_measures_are_those_of_the_program(self):
        for state in self.found:
            told, bodies, pairs = state.measures, state.bodies, state.pairs
            box = state.box()
            self.assertAlmostEqual(told["packing_fraction"], bodies["volume_m3"].sum() / np.prod(box), 9)
            self.assertAlmostEqual(told["coordination"], bodies["coordination"].mean(), 9)
            if told["coordination_of_bodies"] > 0:
                row = pairs.where(pairs["wall"] == -1)
                self.assertEqual(len(row), 1)
                self.assertAlmostEqual(told["mean_normal_force_N"] / row["normal_force_N"][0], 1, 6)
                self.assertAlmostEqual(told["fabric_1"], 1, 9)
            # Stress of the box from the stresses of the bodies: those around them are empty.
            stress = (bodies["mean_stress_Pa"] * bodies["volume_m3"][:, None]).sum(axis=0) / np.prod(box)
            for i, name in enumerate(("xx", "yy", "zz", "xy", "xz", "yz")):
                self.assertAlmostEqual(told[f"stress_{name}_Pa"], stress[i], delta=0.03 * np.abs(stress).max() + 1e-9)
        self.assertGreater(told["top_pressure_Pa"], 0.005)
        self.assertAlmostEqual(told["mean_pressure_Pa"] / told["wall_pressure_Pa"], 1, delta=5e-3)
        self.assertAlmostEqual(told["stress_1_Pa"] + told["stress_2_Pa"] + told["stress_3_Pa"],
                               3 * told["mean_pressure_Pa"], 9)

    def test_history_has_units_of_space(self):
        history = self.found.history_table
        for name, unit in (("top_force_N", "N"), ("elastic_energy_J", "J"), ("axial_strain", ""), ("packing_fraction", "")):
            self.assertEqual(history.unit(name), unit)
        self.assertAlmostEqual(history["axial_strain"][-1], 0.15, delta=0.03)
        self.assertGreaterEqual(history["axial_strain"][-1], 0.15)
        self.assertAlmostEqual(history["packing_fraction"][-1], self.found[-1].measures["packing_fraction"], 8)
        self.assertAlmostEqual(history["elastic_energy_J"][-1], self.found[-1].energies["elastic_energy_J"], 8)

    def test_both_files_tell_the_same(self):
        ours, fields = self.found.snapshots[-1], self.found.fields[-1]
        for part in ("bodies", "points", "contacts"):
            one, other = getattr(ours, part), getattr(fields, part)
            self.assertEqual(len(one), len(other), part)
            shared = [name for name in one if name in other]
            self.assertGreater(len(shared), 4, part)
            for name in shared:
                scale = np.abs(one[name]).max()
                np.testing.assert_allclose(other[name], one[name], atol=3e-6 * scale, rtol=0, err_msg=f"{part} {name}")
        self.assertEqual(len(ours.surfaces), len(fields.surfaces))
        for b in (0, 1):
            vertices, triangles = ours.surfaces[b]
            corners = vertices[triangles]
            volume = (corners[:, 0] * np.cross(corners[:, 1], corners[:, 2])).sum() / 6
            self.assertAlmostEqual(volume / ours.bodies["volume_m3"][b], 1, 1)
            np.testing.assert_allclose(fields.surfaces[b][0][fields.surfaces[b][1]], corners, atol=1e-5)

    def test_components_and_units(self):
        state = self.found[-1]
        self.assertIn("center_z_m", state.bodies.flat())
        self.assertIn("stress_yz_Pa", state.points.flat())
        self.assertIn("deformation_gradient_zx", state.points.flat())
        self.assertEqual(state.bodies.units["volume_m3"], "m³")
        self.assertEqual(state.contacts.units["force_N"], "N")
        J = np.linalg.det(state.points["deformation_gradient"].reshape(-1, 3, 3))
        np.testing.assert_allclose(state.points["volume_strain"], np.log(J), atol=1e-12)
        self.assertEqual(self.found.dimension, 3)

    def test_what_is_not_there_is_said(self):
        state = self.found[-1]
        for what in (lambda: state.outlines, lambda: state.loads, lambda: state.contact_pressures, state.to_xarray,
                     lambda: state.to_vtk("points")):
            with self.assertRaisesRegex(softgrain.InputError, "not there yet"):
                what()
        with self.assertRaisesRegex(softgrain.InputError, "no surface of a body 2; there are 2 bodies"):
            state.surfaces[2]

    def test_a_ball_fills_its_pixels(self):
        vertices, triangles = self.found[0].surfaces[0]  # at rest
        center, radius = np.array([0.12, -0.08, 2.4]), 2.3
        for angles in ((-90, 0), (20, 50)):
            camera = raster.camera_around(vertices, raster.directions(*angles), 200)
            facing = np.sign(raster.normals_of(vertices, triangles) @ camera.axes[2])
            every = raster.fragments(camera, vertices, triangles)
            seen = raster.nearest(every)
            area = len(seen.pixel) * camera.pixel**2
            self.assertAlmostEqual(area / (np.pi * radius**2), 1, delta=0.02)
            self.assertAlmostEqual(seen.depth.max(), center @ camera.axes[2] + radius, delta=0.02 * radius)
            self.assertEqual(len(np.unique(seen.pixel)), len(seen.pixel))
            place = place_of(seen, vertices, triangles)
            np.testing.assert_allclose(camera.places(seen.pixel, seen.depth), place, atol=1.01 * camera.pixel)
            # Behind a plane through the ball, beside its middle, a disk of the ball is cut.
            beside, side = 0.4 * radius, np.sign(camera.axes[2][1])
            behind = every.where(side * (place_of(every, vertices, triangles)[:, 1] - center[1]) < beside)
            pixel, own = cut_through(behind, np.zeros(len(triangles), dtype=int), facing, 1)
            cut = len(pixel) * camera.pixel**2 / abs(camera.axes[2][1])
            self.assertAlmostEqual(cut / (np.pi * (radius**2 - beside**2)), 1, delta=0.03)
            self.assertTrue((own == 0).all())

    def test_pictures_show_what_they_are_asked_for(self):
        def picture(*words):
            file = os.path.abspath("picture.png")
            self.assertEqual(tool_runs.run("render.py", "out", "--output", file, "--dpi", "60", *words)[0], 0)
            return matplotlib.image.imread(file)[:, :, :3]

        plain, again = picture("--field", "none"), picture("--field", "none")
        self.assertTrue((plain == again).all())
        red = lambda image: ((image[:, :, 0] > 0.4) & (image[:, :, 1] < 0.25)).mean()  # noqa: E731
        self.assertEqual(red(plain), 0)
        self.assertGreater(red(picture("--field", "none", "--contacts", "chains")), 0.002)
        self.assertGreater(np.abs(picture("--field", "pressure") - picture("--field", "von_mises")).mean(), 0.02)
        whole, cut = picture("--field", "body"), picture("--field", "body", "--cut", "y=0")
        self.assertEqual(whole.shape, cut.shape)
        self.assertGreater(np.abs(whole - cut).mean(), 0.005)
        words = ("--frame", "all", "--field", "coordination", "--dpi", "40")
        self.assertEqual(tool_runs.run("render.py", "out", *words)[0], 0)
        self.assertEqual(len(os.listdir("out/pictures")), 3)

    def test_the_report_shows_them(self):
        self.assertEqual(tool_runs.run("report.py", "out", "--no-film")[0], 0)
        with open("out/report.html", encoding="utf-8") as file:
            page = file.read()
        for text in ("data:image/png", "Forces on the walls", "top_force_N", "mean normal force"):
            self.assertIn(text, page)

    def test_words_of_the_plane_are_refused(self):
        for words, text in ((("--zoom", "2"), "is for the plane"), (("--contacts", "arrows"), "is for the plane"),
                            (("--field", "pressure,body"), "one field at a time"), (("--cut", "w=1"), "an axis and a place"),
                            (("--cut", "z=1", "--view", "0", "0"), "choose another --view")):
            code, _, error = tool_runs.run("render.py", "out", *words)
            self.assertEqual(code, 2)
            self.assertIn(text, error)
        code, _, error = tool_runs.run("render.py", common.EXAMPLE, "--cut", "x=0")
        self.assertEqual(code, 2)
        self.assertIn("--cut is for runs in space", error)


class SpaceObstacles(unittest.TestCase):
    """A ball on a tilted plate that turns, before anything has happened and after a step."""

    def test_sheets_of_obstacles(self):
        scene = SCENE[: SCENE.index("subsection Packing")] + """
subsection Bodies
  set Names = ball
  subsection ball
    set Shape  = sphere
    set Radius = 2.5
  end
end
subsection Obstacles
  set Names = plate, tube
  subsection plate
    set Points    = 0, -3.1; 4, -3.1
    set Thickness = 1
    set Angle     = 10*t
    set Friction  = 0.5
  end
  subsection tube
    set Points    = 3.6, -3; 3.6, 3
    set Axis      = 1, 0, 0
    set Thickness = 1
    set Displacement = 0; 0; t
  end
end
subsection Mesh
  set Lower     = -3, -3, -3
  set Upper     = 3, 3, 3
  set Cell size = 0.9
end
subsection Time
  set Scheme    = moreau_jean
  set Time step = 0.01
end
subsection Stop
  set End time = 0.02
end
subsection Output
  set Fields every    = 0.02
  set Snapshots every = 0.02
end
"""
        with open("sheets.prm", "w", encoding="utf-8") as file:
            file.write(scene)
        subprocess.run([common.PROGRAM, "run", "sheets.prm", "--threads", "1", "--output", "sheets"], check=True,
                       stdout=subprocess.DEVNULL)
        found = softgrain.open("sheets")
        for state in (found.snapshots[-1], found.fields[-1]):
            table = state.obstacles
            self.assertEqual(len(table), 2)
            np.testing.assert_allclose(table["pivot_m"], [[0, 0, 0], [0, 0, 0.02]], atol=1e-7)
            np.testing.assert_allclose(table["angle_rad"], [np.radians(0.2), 0], atol=1e-9)
            self.assertEqual(table["force_N"].shape, (2, 3))
            self.assertEqual(len(state.obstacle_surfaces), 2)
            vertices, triangles = state.obstacle_surfaces[1]
            np.testing.assert_allclose(np.hypot(vertices[:, 1], vertices[:, 2] - 0.02), 3.6, atol=1e-5)
            sides = vertices[triangles]
            area = np.linalg.norm(np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0]), axis=1).sum() / 2
            self.assertAlmostEqual(area / (2 * np.pi * 3.6 * 6), 1, 2)
            with self.assertRaisesRegex(softgrain.InputError, "no surface of a sheet 2; there are 2 obstacles"):
                state.obstacle_surfaces[2]
        self.assertEqual(found.snapshots[-1].obstacles["name"].tolist(), ["plate", "tube"])
        self.assertEqual(found.history_table.unit("plate_torque_N_m"), "N m")
        images = []
        for words in ((), ("--cut", "y=0")):
            self.assertEqual(tool_runs.run("render.py", "sheets", "--output", "sheets.png", "--dpi", "40", *words)[0], 0)
            images.append(matplotlib.image.imread("sheets.png"))
        self.assertGreater(np.abs(images[0] - images[1]).mean(), 0.005)



if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
