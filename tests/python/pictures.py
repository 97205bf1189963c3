# SPDX-License-Identifier: LGPL-2.1-or-later
"""Films, zoom, fields of bodies and strains, chains with one scale, curves of measures. Arguments: see common.py."""

import json
import os
import re
import shutil
import subprocess
import sys
import unittest
from xml.etree import ElementTree

import common
import h5py
import matplotlib.image
import matplotlib.pyplot as plt
import numpy as np
import softgrain
from softgrain import film
from softgrain.cell import SpreadState, cell_of
from softgrain.dissipation import draw_dissipation
from softgrain.picture import Options, Picture
from softgrain.profiles import of_moments
from softgrain.state import Outlines
from softgrain.tables import Table
from tool_runs import run

PNG = ("--dpi", "50")


def shape(path):
    return matplotlib.image.imread(path).shape[:2]


class OfCell:
    """A disk in a corner and one in the middle of a cell of 2 x 1 whose copy above stands 0.5 to the right; they touch across a side."""
    number, time, obstacle_lines = 0, 0., ()

    def __init__(self):
        turn = np.linspace(0, 2 * np.pi, 25)[:-1]
        circle = 0.3 * np.stack([np.cos(turn), np.sin(turn)], axis=1)
        centers = np.array([[0.1, 0.1], [1.1, 0.5]])
        self.outlines = Outlines({0: [circle + centers[0]], 1: [circle + centers[1]]})
        self.bodies = Table({"body": np.array([0, 1]), "center_m": centers})
        self.contacts = Table({"body_a": np.array([1]), "body_b": np.array([0]), "wall": np.array([-1]),
                               "place_m": np.array([[0.85, 0.8]]), "image_m": np.array([[0.5, 1.]]),
                               "normal": np.array([[0.83, -0.55]]), "force_N_per_m": np.array([[0.83, -0.55]])})
        low, high = [0., 0.], [2., 1.]
        self.walls = Table({"repeats": np.ones(4), "offset_m": np.full(4, 4.5),  # that of 0.5, two widths on
                            "normal": np.array([[0., 1.], [0., -1.], [1., 0.], [-1., 0.]]),
                            "ends_m": np.array([[low, [2., 0.]], [[0., 1.], high], [low, [0., 1.]], [[2., 0.], high]])})

    def has(self, part):
        return part in ("outlines", "bodies", "contacts", "walls")


class Pictures(unittest.TestCase):
    def test_images_of_a_cell(self):
        state = OfCell()
        spread = SpreadState(state, cell_of(state), (0., 0.), (2., 1.))
        centers = {tuple(center.round(9)) for center, owner in zip(spread.bodies["center_m"], spread.owner) if owner == 0}
        # The corner's images that reach into the cell: beside it, above, and above to the left.
        self.assertLessEqual({(0.1, 0.1), (2.1, 0.1), (0.6, 1.1)}, centers)
        for row in range(len(spread.contacts["body_a"])):
            a, b = spread.contacts["body_a"][row], spread.contacts["body_b"][row]
            way = spread.bodies["center_m"][b] - spread.bodies["center_m"][a]
            self.assertTrue(np.allclose(way, [-0.5, 0.6]), way)  # always to the image it meets
        self.assertEqual(len(state.contacts), 1)
        self.assertGreater(len(spread.contacts), 1)

    def draw(self, tool, *arguments):
        code, printed, errors = run(tool, *arguments)
        self.assertEqual((code, errors), (0, ""), errors)
        return printed.split()

    def refused(self, words, tool, *arguments):
        code, _, errors = run(tool, *arguments)
        self.assertEqual((code, len(errors.splitlines())), (2, 1), errors)
        self.assertIn(words, errors)

    def test_frames_have_one_size(self):
        frames = self.draw("render.py", common.EXAMPLE, "--frame", "all", "--output", "frame.png", *PNG)
        self.assertEqual(len(frames), len(softgrain.open(common.EXAMPLE)))
        self.assertEqual(len({shape(path) for path in frames}), 1)

    def test_film(self):
        n = len(softgrain.open(common.EXAMPLE))
        gif, = self.draw("render.py", common.EXAMPLE, "--film", "film.gif", "--fps", "5", *PNG)
        try:
            from PIL import Image
        except ImportError:
            self.skipTest("Pillow is not there to look at the film")
        # By whatever is there, then by Pillow: all frames, the right time.
        for path in (gif, self.by_pillow()):
            with Image.open(path) as image:
                self.assertEqual((image.n_frames, image.info["duration"]), (n, 200))
        if not shutil.which("ffmpeg"):
            self.refused("apt install ffmpeg", "render.py", common.EXAMPLE, "--film", *PNG)
            return
        path, = self.draw("render.py", common.EXAMPLE, "--film", "--output", "film.mp4", "--field", "strain", *PNG)
        self.assertEqual(path, "film.mp4")
        done = subprocess.run(["ffprobe", "-v", "error", "-count_frames", "-select_streams", "v", "-show_entries",
                               "stream=nb_read_frames,width,height", "-of", "json", path], text=True, check=True,
                              capture_output=True)
        stream = json.loads(done.stdout)["streams"][0]
        self.assertEqual((int(stream["nb_read_frames"]), stream["width"] % 2, stream["height"] % 2), (n, 0, 0))

    def by_pillow(self):
        search, os.environ["PATH"] = os.environ["PATH"], ""
        try:
            path, = self.draw("render.py", common.EXAMPLE, "--film", "pillow.gif", "--fps", "5", *PNG)
            self.refused("apt install ffmpeg", "render.py", common.EXAMPLE, "--film", "film.mp4")
        finally:
            os.environ["PATH"] = search
        return path

    def test_film_before_the_folder(self):
        shutil.copytree(common.EXAMPLE, "copy")
        if shutil.which("ffmpeg"):
            self.assertEqual(self.draw("render.py", *PNG, "--film", "copy"), ["copy/pictures/von_mises_Pa.mp4"])
        # A power of ten below zero is no option.
        self.draw("render.py", "copy", "--range", "-1e4", "1e4", "--field", "pressure", "--zoom", "-1e-3", "0", "2e-3", "3e-3",
                  *PNG)

    def test_film_is_refused(self):
        self.refused("must be .mp4 or .gif", "render.py", common.EXAMPLE, "--film", "film.avi")
        self.refused("--film a.png: the ending must be .mp4 or .gif", "render.py", common.EXAMPLE, "--film", "--output", "a.png")
        self.refused("both name the film", "render.py", common.EXAMPLE, "--film", "a.mp4", "--output", "b.mp4")
        self.refused("leave --frame out", "render.py", common.EXAMPLE, "--film", "--frame", "2")
        with self.assertRaisesRegex(softgrain.InputError, "must be .mp4 or .gif"):
            film.require_maker("film.webm")

    def test_fields(self):
        for field in ("strain", "shear_strain", "velocity:y", "coordination", "mean_pressure", "bodies/velocity",
                      "mean_stress:yy", "volume_strain"):
            path, = self.draw("render.py", common.EXAMPLE, "--field", field, "--output", "field.png", *PNG)
            image = matplotlib.image.imread(path)[..., :3]
            self.assertGreater(np.ptp(image, axis=2).max(), 0.3, field)  # there is colour
        self.refused("of whole bodies: area_m2, contact_force_N_per_m", "render.py", common.EXAMPLE, "--field", "colour")
        self.refused("no field 'presure' in ", "render.py", common.EXAMPLE, "--field", "presure")
        self.refused("did you mean pressure_Pa?", "render.py", common.EXAMPLE, "--field", "presure")
        listed = " ".join(self.draw("render.py", common.EXAMPLE, "--list"))
        self.assertIn("equivalent_strain", listed)
        self.assertIn("coordination", listed)

    def test_contact_pressure(self):
        """The pieces of all contacts press as their forces do, and a picture shows them in colour; a number that is no width is refused."""
        state = softgrain.open(common.EXAMPLE)[-1]
        pieces, pairs = state.contact_pressures, state.pairs
        found = np.bincount(pieces.contact, pieces.contact_pressure_Pa * pieces.length_m)
        np.testing.assert_allclose(found, pairs.normal_force_N_per_m, rtol=1e-3)  # a pair has one normal, its places have theirs
        self.assertGreater(len(pieces), 20 * len(pairs))
        mesh = state.to_vtk("contact_pressures")
        self.assertEqual(mesh.GetPointData().GetArray("contact_pressure_Pa").GetNumberOfTuples(), len(pieces))
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(state.to_vtp("pressures.vtp", "contact_pressures"))
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), len(pieces))
        with self.assertRaisesRegex(softgrain.InputError, "ends with .vtp"):
            state.to_vtp("pressures.vtk", "contact_pressures")
        run = softgrain.open(common.EXAMPLE)
        with open(run.to_pvd("pressures.pvd", "contact_pressures"), encoding="utf-8") as file:
            series = [(float(data.get("timestep")), data.get("file")) for data in ElementTree.parse(file).iter("DataSet")]
        self.assertEqual([time for time, _ in series], list(run.times))
        reader.SetFileName(series[-1][1])
        reader.Update()
        self.assertEqual(reader.GetOutput().GetNumberOfPoints(), len(pieces))
        with self.assertRaisesRegex(softgrain.InputError, "ends with .pvd"):
            run.to_pvd("pressures.vtp")
        mesh = state.to_vtk("outlines")
        pressure, length = (vtk_to_numpy(mesh.GetPointData().GetArray(name)) for name in ("contact_pressure_Pa", "length_m"))
        self.assertEqual(len(pressure), len(state.outlines.points_m))
        bodies = 1 + (pieces.wall == -1)  # on whose outlines a contact is seen
        self.assertAlmostEqual(pressure @ length / (bodies * pieces.contact_pressure_Pa * pieces.length_m).sum(), 1, 12)
        self.assertLess(abs(pressure.max() / pieces.contact_pressure_Pa.max() - 1), 0.05)
        # The run's own pictures have the same, without anything made afterwards.
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
        own = vtkXMLUnstructuredGridReader()
        with open(run.path("fields.pvd"), encoding="utf-8") as file:
            own.SetFileName(run.path([data.get("file") for data in ElementTree.parse(file).iter("DataSet") if data.get("name") == "outlines"][-1]))
        own.Update()
        for name in ("contact_pressure_Pa", "contact_traction_Pa"):
            here, there = (vtk_to_numpy(grid.GetPointData().GetArray(name)) for grid in (own.GetOutput(), mesh))
            np.testing.assert_allclose(here, there, rtol=0, atol=1e-5 * pressure.max(), err_msg=name)
        first = pieces.where(pieces.contact == 0)
        self.assertGreater(first.contact_pressure_Pa.argmax(), 10)  # not at an end
        path, = self.draw("render.py", common.EXAMPLE, "--field", "contact_pressure", "--output", "pressures.png", *PNG)
        image = matplotlib.image.imread(path)[..., :3]
        self.assertGreater(np.ptp(image, axis=2).max(), 0.3)
        self.refused("did you mean contact_pressure", "render.py", common.EXAMPLE, "--field", "contact_presure")
        # All around there is no way along: each place stands for itself.
        around = np.linspace(0, 2 * np.pi, 8, endpoint=False)
        out = np.stack([np.cos(around), np.sin(around)], axis=1)
        state.__dict__["contacts"] = Table({"body_a": np.zeros(8, dtype=int), "body_b": np.ones(8, dtype=int), "wall": np.full(8, -1),
                                            "place_m": out, "normal": -out, "force_N_per_m": -3. * out, "length_m": np.full(8, 0.5)})
        state.__dict__.pop("pairs"), state.__dict__.pop("contact_pressures")
        np.testing.assert_allclose(state.contact_pressures.contact_pressure_Pa, 6.)
        rows = {"along_m": np.array([-1., 0., 1.]), "pressed": np.ones(3), "rubbed": np.zeros(3), "length_m": np.ones(3),
                "place_m": np.zeros((3, 2)), "tangent": np.tile([0., 1.], (3, 1))}
        with self.assertRaisesRegex(softgrain.InputError, "bears its force at 3 places alone, which tells no width"):
            of_moments(rows, 2., None)
        by_law = of_moments(rows, 2., 1.5)
        self.assertEqual((by_law.half_width_m, by_law.width_from), (1.5, "Hertz's law"))
        self.assertAlmostEqual(float(by_law.pressure_Pa @ by_law.length_m), 3.)
        # The force of a single place is spread along its tangent: else a narrow contact would not be seen.
        single = of_moments({name: values[1:2] for name, values in rows.items()}, 2., 1.5)
        np.testing.assert_allclose(single.place_m, np.stack([0 * single.along_m, single.along_m], axis=1), atol=1e-12)

    def test_titles_of_a_series(self):
        """One unit of time, as many digits in all, and what the scene goes by: the strain that ends it, or the packing fraction."""
        run_ = softgrain.open(common.EXAMPLE)
        titles = [Picture(Options(), run_[:]).title(state) for state in run_]
        self.assertRegex(titles[0], r"^\$t\$ = 0.000 ms      \$\\varepsilon\$ = 0.000$")
        self.assertTrue(all(re.match(r"^\$t\$ = \d\.\d{3} ms      \$\\varepsilon\$ = 0\.\d{3}$", title) for title in titles), titles)
        shutil.copytree(common.EXAMPLE, "by_phi", ignore=shutil.ignore_patterns("fields*"))
        path = "by_phi/parameters.prm"
        with open(path, encoding="utf-8") as file:
            text = file.read()
        changed = re.sub(r"set Axial strain( *)= 0.08", r"set Axial strain\1= 0", text)
        changed = re.sub(r"set Packing fraction( *)= 0(\.0*)?\n", r"set Packing fraction\1= 0.9\n", changed)
        self.assertNotEqual(text, changed)
        with open(path, "w", encoding="utf-8") as file:
            file.write(changed)
        other = softgrain.open("by_phi")
        self.assertEqual((run_.coordinate, other.coordinate), ("axial_strain", "packing_fraction"))
        value = other.history_table["packing_fraction"][-1]
        self.assertIn(rf"$\Phi$ = {value:.3f}", Picture(Options(), [other[-1]]).title(other[-1]))

    def test_side_by_side(self):
        path, = self.draw("render.py", common.EXAMPLE, "--field", "pressure,strain", "--output", "both.png", *PNG)
        single, = self.draw("render.py", common.EXAMPLE, "--field", "pressure", "--width", "4.2", "--output", "one.png", *PNG)
        self.assertEqual(shape(path), (shape(single)[0], 2 * shape(single)[1]))
        figure = softgrain.open(common.EXAMPLE)[-1].plot(["pressure", "strain"])
        labels = [axes.get_ylabel() for axes in figure.axes]
        self.assertTrue(labels[1].startswith("Pressure") and labels[3].startswith("Equivalent strain"), labels)
        plt.close("all")
        self.refused("--range is for one field", "render.py", common.EXAMPLE, "--field", "pressure,strain", "--range", "0", "1")
        self.refused("--width 1.5 leaves no room", "render.py", common.EXAMPLE, "--width", "1.5")

    def test_dissipation(self):
        """Kinds lie on each other up to what is dissipated in all."""
        path, = self.draw("plot.py", common.EXAMPLE, "--preset", "dissipation", "--output", "kinds.svg")
        with open(path, encoding="utf-8") as file:
            text = file.read()
        for word in ("contacts", "time scheme", "Dissipated energy"):
            self.assertIn(word, text)
        figure, axes = plt.subplots()
        run_ = softgrain.open(common.EXAMPLE)
        draw_dissipation(axes, run_, "time_s")
        top = max(area.get_paths()[0].vertices[:, 1].max() for area in axes.collections)
        self.assertAlmostEqual(top / axes.lines[0].get_ydata()[-1], 1, delta=1e-3)
        plt.close("all")
        self.refused("goes without --y", "plot.py", common.EXAMPLE, "--preset", "dissipation", "--y", "top_force")

    def test_zoom(self):
        run_ = softgrain.open(common.EXAMPLE)
        for zoom, width in (((2,), None), ((0, 0, 2e-3, 1e-3), 2e-3)):
            picture = Picture(Options(zoom=zoom), [run_[-1]])
            axes = picture.figure(run_[-1]).axes[0]
            full = Picture(Options(), [run_[-1]])
            expected = width or (full.high[0] - full.low[0]) / 2
            self.assertAlmostEqual(np.ptp(axes.get_xlim()), expected, places=9)
        plt.close("all")
        self.refused("shows nothing", "render.py", common.EXAMPLE, "--zoom", "1", "1", "2", "2")
        self.refused("--zoom takes", "render.py", common.EXAMPLE, "--zoom", "1", "2")
        self.refused("--zoom takes", "render.py", common.EXAMPLE, "--zoom", "0")

    def test_chains_have_one_scale(self):
        run_ = softgrain.open(common.EXAMPLE)
        together = Picture(Options(contacts="chains"), run_[:])
        last = Picture(Options(contacts="chains"), [run_[-1]])
        self.assertGreaterEqual(together.full_force, last.full_force)
        widths = {}
        for number in (2, -1):
            figure = together.figure(run_[number])
            texts = [text.get_text() for text in figure.texts]
            self.assertEqual(len([text for text in texts if text.startswith("force ")]), 1, texts)
            force = run_[number].pairs["force_N_per_m"]
            widths[number] = (max(max(line.get_linewidths()) for line in figure.axes[0].collections
                                  if isinstance(line, matplotlib.collections.LineCollection)
                                  and line.get_zorder() == 5.1), np.hypot(*force.T).max(), texts)
        plt.close("all")
        (early, early_force, legend), (late, late_force, same) = widths.values()
        self.assertAlmostEqual(early / late, early_force / late_force, delta=1e-6)
        self.assertEqual(legend, same)

    def test_states_without_fields(self):
        bare = os.path.join(common.WORK, "bare")
        shutil.copytree(common.EXAMPLE, bare, ignore=shutil.ignore_patterns("fields*", "*.csv"))
        self.draw("render.py", bare, "--output", "bare.png", *PNG)
        figure = softgrain.open(bare)[-1].plot("pressure_Pa", contacts="none")
        self.assertEqual(len(figure.axes), 2)
        plt.close("all")

    def test_curves(self):
        listed = " ".join(self.draw("plot.py", common.EXAMPLE, "--list"))
        self.assertIn("contact_anisotropy", listed)
        self.draw("plot.py", common.EXAMPLE, "--y", "contact_anisotropy", "packing_fraction", "--output", "curves.png")
        run_ = softgrain.open(common.EXAMPLE)
        axes = run_.plot("specific_contact_surface", x="axial_strain")
        x, y = axes.lines[0].get_data()
        np.testing.assert_array_equal(y, run_.measures_table["specific_contact_surface"])
        np.testing.assert_allclose(x, [state.strain for state in run_], atol=1e-12)
        self.assertEqual(run_.plot("bottom_force").get_xlabel()[:12], "Axial strain")
        plt.close("all")

    def test_fits(self):
        folder = os.path.join(common.WORK, "law")
        os.makedirs(folder)
        x = np.linspace(0.8, 0.98, 60)
        with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
            file.write("time_s,packing_fraction,coordination,noise\n")
            for row in zip(1e-3 * np.arange(60), x, 3.5 + 4 * np.sqrt(x - 0.8), np.random.default_rng(1).normal(size=60)):
                file.write(",".join(f"{value:.9g}" for value in row) + "\n")
        columns = ("--x", "packing_fraction", "--dpi", "50", "--y")
        _, *words = self.draw("plot.py", folder, *columns, "coordination", "--fit", "power")
        found = " ".join(words)
        for text in ("a = 3.5,", "b = 4,", "x0 = 0.8,", "c = 0.5,", "R² = 1.0000"):
            self.assertIn(text, found)
        code, _, errors = run("plot.py", folder, *columns, "noise", "--fit", "line")
        self.assertEqual(code, 0)
        self.assertRegex(errors, "plot: warning: the line of noise of .* fits poorly, R² = 0.0")
        self.refused("fewer than 5 points", "plot.py", folder, *columns, "noise", "--fit", "line", "--fit-range", "0.97", "0.98")
        self.refused("needs --fit", "plot.py", folder, "--fit-range", "0", "1")

    def test_default_without_walls(self):
        folder = os.path.join(common.WORK, "free")
        os.makedirs(folder)
        with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
            file.write("time_s,step,axial_strain,kinetic_energy_J_per_m,elastic_energy_J_per_m\n0,0,,0,1\n1,1,,1,2\n")
        path, = self.draw("plot.py", folder)
        self.assertEqual(os.path.basename(path), "kinetic_energy-elastic_energy-against-time.png")

    def test_damaged_snapshots(self):
        broken = os.path.join(common.WORK, "broken")
        shutil.copytree(common.EXAMPLE, broken, ignore=shutil.ignore_patterns("fields*"))
        with open(os.path.join(broken, "snapshots/000005.h5"), "r+b") as file:
            file.truncate(2000)
        self.refused("is damaged", "render.py", broken)
        with h5py.File(os.path.join(broken, "snapshots.h5"), "r+") as file:
            del file["time_s"]
        self.refused("is damaged", "render.py", broken)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
