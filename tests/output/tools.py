# SPDX-License-Identifier: LGPL-2.1-or-later
"""render.py and plot.py on synthetic output: what they read, draw and refuse. Arguments: PYTHON_DIR SOURCE WORK."""

import os
import shutil
import subprocess
import sys
import unittest

SOURCE, WORK = map(os.path.abspath, sys.argv[2:4])

import tool_runs  # noqa: E402  (before matplotlib and the tools)

import h5py  # noqa: E402
import matplotlib.image  # noqa: E402
import numpy as np  # noqa: E402

import softgrain  # noqa: E402
from softgrain import Run, drawing, fields, split_unit, theory  # noqa: E402
from softgrain.parameters import Parameters  # noqa: E402


def run(tool, *arguments):
    """Runs a tool within this process, with the answer of run_alone()."""
    return subprocess.CompletedProcess(arguments, *tool_runs.run(tool, *arguments))


def run_alone(tool, *arguments, path=""):
    """Runs a tool as a user does, without a display; @path comes first in the search for libraries."""
    environment = dict(os.environ, PYTHONPATH=path, PYTHONDONTWRITEBYTECODE="1")
    environment.pop("DISPLAY", None)
    return subprocess.run([sys.executable, os.path.join(tool_runs.TOOLS, tool), *arguments], cwd=WORK, env=environment,
                          capture_output=True, text=True, check=False)


class Tools(unittest.TestCase):
    def picture(self, tool, *arguments):
        """Runs a tool and returns the last picture it names as an array."""
        done = run(tool, *arguments)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done)
        path = done.stdout.splitlines()[-1]
        self.assertFalse([name for name in os.listdir(os.path.dirname(path) or ".") if name.startswith(".part")])
        if not path.endswith(".png"):
            with open(path, "rb") as file:
                return file.read()
        image = matplotlib.image.imread(path)
        self.assertGreater(min(image.shape[:2]), 100)
        self.assertGreater(image[..., :3].std(), 0.05, "the picture is blank")
        return image

    def refused(self, tool, *arguments, words=(), done=None):
        done = done or run(tool, *arguments)
        self.assertEqual(done.returncode, 2, done)
        self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)

    def test_fields_are_read_by_vtk(self):
        series = fields.read_series(os.path.join(WORK, "disk"))
        self.assertEqual([round(frame.time, 9) for frame in series], [0, 0.005, 0.01, 0.015])
        self.assertEqual(set(series[0].files), {"points", "outlines", "contacts", "walls"})
        points = fields.read_grid(series[-1].files["points"])
        data = points.point_data
        self.assertEqual(len(points.cells), len(points.points))
        with open(series[-1].files["points"], "rb") as file:
            self.assertIn(b'ComponentName1="XY"', file.read(5000))
        self.assertEqual(data["deformation_gradient"].shape, (len(points.points), 4))
        self.assertEqual(data["velocity_m_per_s"].shape, (len(points.points), 3))
        self.assertIn("strain_energy_J_per_m3", data)
        # A symmetric tensor of nine components, as ParaView has them, with nothing out of the plane but zz.
        stress = data["stress_Pa"].reshape(-1, 3, 3)
        np.testing.assert_array_equal(stress, stress.transpose(0, 2, 1))
        np.testing.assert_array_equal(stress[:, 2, :2], 0)
        self.assertGreater(np.abs(stress[:, 0, 1]).max(), 1e3)
        np.testing.assert_allclose(stress[:, 2, 2], 0.45 * (stress[:, 0, 0] + stress[:, 1, 1]), rtol=1e-4, atol=1)
        mean = -np.trace(stress, axis1=1, axis2=2) / 3
        np.testing.assert_allclose(data["pressure_Pa"], mean, rtol=1e-4, atol=1)
        self.assertTrue((data["von_mises_Pa"] > 0).all())
        outlines = fields.read_grid(series[-1].files["outlines"])
        self.assertEqual([len(cell) for cell in outlines.cells], [240])
        x, y = outlines.points.T
        inside = 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
        np.testing.assert_allclose(data["area_m2"].sum(), inside, rtol=0.01)
        np.testing.assert_allclose(np.ptp(outlines.points[:, 1]), 7e-3, rtol=0.01)
        contacts = fields.read_grid(series[-1].files["contacts"])
        self.assertTrue((contacts.point_data["body_b"] == -1).all())
        on_bottom = contacts.point_data["wall"] == 0
        walls = fields.read_grid(series[-1].files["walls"])
        np.testing.assert_allclose(contacts.point_data["normal_force_N_per_m"][on_bottom].sum(),
                                   walls.cell_data["normal_force_N_per_m"][0], rtol=0.05)
        self.assertEqual(len(fields.read_grid(series[0].files["contacts"]).points), 0)
        # ParaView warns when two parts have an array of one name with different numbers of components.
        widths = {}
        for grid in (points, outlines, contacts, walls):
            for name, values in (*grid.point_data.items(), *grid.cell_data.items()):
                self.assertEqual(widths.setdefault(name, values.shape[1:]), values.shape[1:], name)

    def test_snapshots_are_read_by_h5py(self):
        with h5py.File(os.path.join(WORK, "disk", "snapshots.h5")) as file:
            np.testing.assert_allclose(file["time_s"], [0, 0.005, 0.01, 0.015])
            last = file["steps/000003"]
            self.assertEqual(last.attrs["time_s"], file["time_s"][3])
            self.assertEqual(last["points/position_m"].shape[1], 2)
            self.assertEqual(last["bodies/name"][0], b"disk")
            found = {}
            last.visititems(lambda name, item: found.update({name: item.attrs["units"].decode()}) if "units" in item.attrs else None)
            for name, unit in (("points/stress_Pa", "Pa"), ("points/area_m2", "m^2"), ("contacts/force_N_per_m", "N/m"),
                               ("bodies/angular_momentum_kg_m_per_s", "kg m/s"), ("points/deformation_gradient", "1"),
                               ("walls/velocity_m_per_s", "m/s"), ("points/extra/strain_energy_J_per_m3", "J/m^3"),
                               ("energies/kinetic_energy_J_per_m", "J/m")):
                self.assertEqual(found[name], unit)
            numbers = []
            last.visititems(lambda name, item: numbers.append(name) if getattr(item, "dtype", None) == float else None)
            self.assertEqual(sorted(numbers), sorted(found))
            self.assertEqual(file["time_s"].attrs["units"], b"s")
            # The Python package says the same of a table as of its names, with the signs that print well.
            for part in ("points", "bodies", "contacts", "walls"):
                table = Run(os.path.join(WORK, "disk")).snapshots[3].source.table(part)
                self.assertEqual(table.units, {name: split_unit(name)[1] for name in table})
            begin, end = last["outlines/ring_offsets"][:2]
            self.assertEqual(last["outlines/points_m"][begin:end].shape, (240, 2))

    def test_render(self):
        self.picture("render.py", "disk")
        self.assertTrue(os.path.exists(os.path.join(WORK, "disk/pictures/von_mises_Pa-000003.png")))
        self.picture("render.py", "packing", "--dpi", "110")
        self.picture("render.py", "packing", "--style", "disks", "--contacts", "none", "--dpi", "60", "--width", "6",
                     "--output", "pictures/disks.png")
        self.picture("render.py", "disk", "--field", "velocity_m_per_s:y", "--frame", "0", "--contacts", "chains")
        self.assertIn(b"<svg", self.picture("render.py", "disk", "--field", "none", "--output", "pictures/disk.svg"))
        done = run("render.py", "disk", "--frame", "all", "--dpi", "60", "--output", "pictures/film.png")
        self.assertEqual(done.stdout.split(), [f"pictures/film-{i:06d}.png" for i in range(4)])
        self.assertIn("pressure_Pa", run("render.py", "disk", "--list").stdout)

    def test_plot(self):
        self.picture("plot.py", "disk")
        self.picture("plot.py", "disk", "--preset", "diametral")
        self.picture("plot.py", "disk", "disk2", "--x", "time_s", "--y", "top_force_N_per_m", "axial_strain")
        svg = self.picture("plot.py", "disk", "--preset", "diametral", "--output", "pictures/curve.svg").decode()
        self.assertIn("Johnson", svg)
        self.assertIn("thesis (3.31)", svg)
        # A disk between two walls has its theory beside it unless told otherwise.
        self.assertTrue(b"Johnson" in self.picture("plot.py", "disk", "--output", "pictures/own.svg"))
        for choice in (("--theory", "none"), ("--y", "top_force_N_per_m")):
            self.assertFalse(b"Johnson" in self.picture("plot.py", "disk", *choice, "--output", "pictures/bare.svg"))
        # A law without Young's modulus has none, and its curve is drawn all the same.
        shutil.copytree(os.path.join(WORK, "disk"), os.path.join(WORK, "soft"))
        parameters = os.path.join(WORK, "soft/parameters.prm")
        with open(parameters, encoding="utf-8") as file:
            text = file.read()
        with open(parameters, "w", encoding="utf-8") as file:
            file.write(text.replace("Young's modulus", "Shear modulus"))
        self.assertFalse(b"Johnson" in self.picture("plot.py", "soft", "--output", "pictures/soft.svg"))
        self.refused("plot.py", "soft", "--theory", "johnson", words=("--young",))

    def test_plot_without_a_bottom_wall(self):
        for name, header, drawn in (
                ("two_walls", "time_s,left_force_N_per_m,right_force_N_per_m,kinetic_energy_J_per_m",
                 "left_force-right_force-against-time.png"),
                ("no_walls", "time_s,kinetic_energy_J_per_m,elastic_energy_J_per_m,coordination",
                 "kinetic_energy-elastic_energy-against-time.png")):
            os.makedirs(os.path.join(WORK, name), exist_ok=True)
            with open(os.path.join(WORK, name, "history.csv"), "w", encoding="utf-8") as file:
                file.write(f"{header}\n0,1,2,3\n1,2,3,4\n")
            self.picture("plot.py", name)
            self.assertTrue(os.path.exists(os.path.join(WORK, name, "pictures", drawn)))
        self.picture("plot.py", "two_walls", "no_walls")  # the energy that both have
        os.makedirs(os.path.join(WORK, "times"), exist_ok=True)
        with open(os.path.join(WORK, "times/history.csv"), "w", encoding="utf-8") as file:
            file.write("time_s,step\n0,1\n1,2\n")
        self.refused("plot.py", "times", words=("--y", "step"))

    def test_alone(self):
        for tool in ("render.py", "plot.py"):
            done = run_alone(tool, "disk", "--output", f"pictures/alone-{tool}.png")
            self.assertEqual((done.returncode, done.stdout), (0, f"pictures/alone-{tool}.png\n"), done)
            self.refused(tool, words=("absent",), done=run_alone(tool, "absent"))

    def test_errors(self):
        for tool in ("render.py", "plot.py"):
            self.refused(tool, "absent", words=("absent",))
            self.refused(tool, "disk", "--output", "picture.nonsense", words=("picture.nonsense",))
            self.refused(tool, "disk", "--nonsense", words=("--nonsense",))
            self.refused(tool, words=("DIR",))
        self.refused("render.py", "disk", "--field", "presure_Pa", words=("presure_Pa", "pressure_Pa"))
        self.refused("render.py", "disk", "--field", "velocity_m_per_s:q", words=("q",))
        self.refused("render.py", "disk", "--frame", "9", words=("0 to 3",))
        self.refused("render.py", "disk", "--frame", "first", words=("first",))
        self.refused("render.py", "disk", "--colours", "grue", words=("grue",))
        self.refused("render.py", "damaged", words=("points-000003.vtu",))
        self.refused("plot.py", "packing", words=("history.csv",))
        self.refused("plot.py", "disk", "--y", "force", words=("'force'", "bottom_force_N_per_m"))
        self.refused("plot.py", "disk", "--theory", "newton", words=("newton", "johnson"))
        self.refused("plot.py", "damaged", words=("line 5",))

    def test_missing_package(self):
        fake = os.path.join(WORK, "fake")
        os.makedirs(fake)
        with open(os.path.join(fake, "vtkmodules.py"), "w", encoding="ascii") as file:
            file.write("raise ImportError('no VTK here')\n")
        self.refused("render.py", words=("python3-vtk9", "apt install"),
                     done=run_alone("render.py", "disk", path=fake))

    def test_smoothing_keeps_linear_fields(self):
        random = np.random.default_rng(1)
        x, y = np.meshgrid(np.arange(20) + 0.5, np.arange(10) + 0.5)
        points = np.stack([x.ravel(), y.ravel()], axis=1) + random.uniform(-0.2, 0.2, (200, 2))
        image = drawing.smooth_field(points, 3 + 2 * points[:, 0] - points[:, 1], np.ones(200), (1, 19, 1, 9))
        px = 1 + (np.arange(image.shape[1]) + 0.5) * 18 / image.shape[1]
        py = 1 + (np.arange(image.shape[0]) + 0.5) * 8 / image.shape[0]
        np.testing.assert_allclose(image, 3 + 2 * px - py[:, None], atol=0.02)

    def test_arrows_keep_the_force(self):
        along = np.linspace(-1, 1, 41)
        points = np.stack([along, 0.1 * along**2], axis=1)
        # Rows that take turns in carrying: what is drawn is even, and all of it.
        forces = np.stack([np.zeros(41), 1 + (-1.0)**np.arange(41)], axis=1)
        places, drawn = drawing.spread_evenly(along, points, forces, 9)
        self.assertEqual(len(places), 9)
        np.testing.assert_allclose(drawn[1:-1, 1], 1, atol=0.05)
        lengths = np.gradient(places[:, 0]) * np.where(np.isin(np.arange(9), (0, 8)), 0.5, 1)
        np.testing.assert_allclose((drawn[:, 1] * lengths).sum() / 0.05, forces[:, 1].sum())
        np.testing.assert_array_equal(drawing.spread_evenly(along[:4], points[:4], forces[:4], 9)[1], forces[:4])

    def test_theory(self):
        constants = {"young": 10e6, "poisson": 0.45, "radius": 5e-3}
        self.assertAlmostEqual(theory.hertz(0.1, **constants), np.pi / 4 * 10e6 / 0.7975 * 5e-3 * 0.1, places=6)
        # Johnson's approach at the force found is that of the strain.
        force = theory.johnson(0.1, **constants)
        compliance = force * 0.7975 / (np.pi * 10e6)
        a = np.sqrt(4 * compliance * 5e-3)
        approach = compliance * (2 * np.log(4 * 5e-3 / a) - 1)
        self.assertAlmostEqual(-np.log(1 - approach / 5e-3), 0.1, places=5)
        parameters = softgrain.open(os.path.join(WORK, "disk")).parameters
        self.assertEqual(parameters.find_number("Young's modulus", "Materials"), 10e6)
        self.assertEqual(parameters.find_number("Radius", "Bodies"), 5e-3)
        # A number of a law that the material does not use is none of the material's.
        unused = {("Materials", "grain", "Law"): "power_law", ("Materials", "grain", "Power potential", "Force"): "100"}
        self.assertIsNone(Parameters(unused).find_number("Force", "Materials"))
        used = {**unused, ("Materials", "grain", "Law"): "power_potential"}
        self.assertEqual(Parameters(used).find_number("Force", "Materials"), 100)
        self.assertEqual(softgrain.split_unit("kinetic_energy_J_per_m"), ("kinetic_energy", "J/m"))


def prepare():
    shutil.rmtree(WORK, ignore_errors=True)
    for name in ("disk", "packing"):
        shutil.copytree(os.path.join(SOURCE, name), os.path.join(WORK, name))
    for name in ("disk2", "damaged"):
        shutil.copytree(os.path.join(SOURCE, "disk"), os.path.join(WORK, name))
    with open(os.path.join(WORK, "damaged/fields/points-000003.vtu"), "r+b") as file:
        file.truncate(3000)
    with open(os.path.join(WORK, "damaged/history.csv"), "r+", encoding="ascii") as file:
        lines = file.readlines()
        lines[4] = "what,is,this\n"
        file.seek(0)
        file.writelines(lines)
        file.truncate()


prepare()
os.chdir(WORK)
unittest.main(argv=sys.argv[:1], verbosity=1)
