# SPDX-License-Identifier: LGPL-2.1-or-later
"""Arrays of states against measures.csv, against the other kind of file, and converted. Arguments: see common.py."""

import csv
import os
import pickle
import shutil
import sys
import unittest
from unittest import mock

import common
import h5py
import numpy as np
import softgrain
from softgrain import Table
from softgrain.contacts import pairs_of
from softgrain.loads import loads_of


class OfCell:
    """Bodies with contacts, and nothing else."""

    def __init__(self, centers, contacts):
        self.bodies = Table({"body": np.arange(len(centers)), "center_m": centers})
        self.contacts = Table({name: np.array(values) for name, values in contacts.items()})
        self.run = softgrain.open(common.EXAMPLE)


class States(unittest.TestCase):
    def setUp(self):
        self.run_ = softgrain.open(common.EXAMPLE)

    def test_measures_are_those_of_the_program(self):
        compared = 0
        for source in ("snapshots", "fields"):
            for state in softgrain.Run(common.EXAMPLE, source):
                written, ours = state.measures, softgrain.measures.of(state)
                compared += len(ours)
                for name, value in ours.items():
                    scale = 1. if source == "snapshots" else 1e3  # fields are in single precision
                    near = scale * 1e-9 * max(abs(written[name]), 1. if "Pa" not in name else 1e5)
                    self.assertAlmostEqual(value, written[name], delta=near, msg=f"{source} {state.time} {name}")
        self.assertGreater(compared, 150)

    def test_both_files_tell_the_same(self):
        ours, fields = self.run_.snapshots[-1], self.run_.fields[-1]
        self.assertEqual(ours.time, fields.time)
        for part in ("bodies", "points", "contacts", "walls"):
            one, other = getattr(ours, part), getattr(fields, part)
            self.assertEqual(len(one), len(other), part)
            shared = [name for name in one if name in other]
            self.assertGreater(len(shared), 6, part)
            for name in shared:
                if one[name].dtype.kind == "U":
                    self.assertEqual(list(one[name]), list(other[name]))
                    continue
                scale = np.abs(one[name]).max() + (1 if name == "tangential_force_N_per_m" else 0)  # no friction: none
                np.testing.assert_allclose(other[name], one[name], atol=2e-6 * scale, rtol=0, err_msg=f"{part} {name}")
        for body in (0, 1):
            np.testing.assert_allclose(fields.outlines[body][0], ours.outlines[body][0], atol=1e-12)

    def test_one_set_of_names(self):
        """Arrays of snapshots.h5, columns in Python, those of fields.pvd and of history.csv: one thing has one name."""
        with h5py.File(self.run_.path("snapshots.h5")) as file:
            for part in ("bodies", "points", "contacts", "walls"):
                names = {name for name in file[f"steps/000000/{part}"] if not name.startswith("extra")}
                self.assertEqual(names - set(self.run_.snapshots[0].source.table(part)), set(), part)
                self.assertEqual(set(getattr(self.run_.fields[0], part)) - set(getattr(self.run_.snapshots[0], part)), set(), part)
            self.assertEqual(set(file["steps/000000/energies"]) - set(self.run_.history_table), set())
        self.assertEqual(set(self.run_[-1].energies) - set(self.run_.history_table), set())
        with self.assertRaisesRegex(softgrain.MissingName, "'kinetic_J_per_m'; did you mean 'kinetic_energy_J_per_m'"):
            self.run_[-1].energies["kinetic_J_per_m"]

    def test_names_of_before(self):
        """Files of 0.2.0 have some names otherwise; Python and the program read them all the same."""
        shutil.rmtree("old", ignore_errors=True)
        shutil.copytree(common.EXAMPLE, "old")
        for name in os.listdir("old/snapshots"):
            with h5py.File(f"old/snapshots/{name}", "r+") as file:
                for now, before in (("points/area_m2", "points/size_m2"), *(
                        (f"energies/{one}_energy_J_per_m", f"energies/{one}_J_per_m") for one in ("kinetic", "elastic", "dissipated"))):
                    file.move(now, before)
        old = softgrain.open("old")
        self.assertEqual(old[-1].points.area_m2.tolist(), self.run_[-1].points.area_m2.tolist())
        self.assertEqual(old[-1].points.units, self.run_[-1].points.units)
        self.assertEqual(old[-1].energies, self.run_[-1].energies)
        table, written = softgrain.measure("old"), self.run_.measures_table
        for name in written:
            np.testing.assert_array_equal(table[name], written[name], name)

    def test_loads(self):
        """What bodies feel adds up to what walls bear, and what two bodies do to each other is opposite."""
        for state in (self.run_[-1], self.run_.fields[-1]):
            loads, walls = state.loads, state.walls
            for wall in range(len(walls)):
                force = loads.force_N_per_m[loads.wall == wall].sum(axis=0)
                np.testing.assert_allclose(force @ walls.normal[wall], walls.normal_force[wall], rtol=1e-5, atol=1e-3)
            between = loads.where(loads.partner >= 0)
            self.assertEqual((list(between.body), list(between.partner)), ([0, 1], [1, 0]))
            np.testing.assert_allclose(between.force_N_per_m[0], -between.force_N_per_m[1])
            np.testing.assert_allclose(state.bodies.contact_force_N_per_m.sum(axis=0), loads.force_N_per_m[loads.wall >= 0].sum(axis=0),
                                       rtol=1e-6, atol=1e-4)
        over_time = self.run_.loads_on("lower")
        self.assertEqual(set(over_time.partner_name) - {"upper", "bottom", "left", "right"}, set())
        top = over_time.where((over_time.partner_name == "upper") & (over_time.time_s == self.run_.times[-1]))
        last = self.run_[-1].loads
        np.testing.assert_allclose(top.force_N_per_m, last.force_N_per_m[(last.body == 0) & (last.partner == 1)], rtol=1e-12)
        with self.assertRaisesRegex(softgrain.InputError, "no body 'middle' in .*; there are lower, upper"):
            self.run_.loads_on("middle")
        # A force beside the centre has a torque, here of a contact across the side of a cell two metres wide.
        state = OfCell(np.array([[0.5, 0.], [1.5, 0.]]), {"body_a": [0], "body_b": [1], "wall": [-1], "place_m": [[0., 0.1]],
                                                          "image_m": [[-2., 0.]], "force_N_per_m": [[3., 0.]]})
        found = loads_of(state)
        np.testing.assert_allclose(found.torque_N, [-0.3, 0.3])
        np.testing.assert_allclose(found.force_N_per_m, [[3., 0.], [-3., 0.]])

    def test_strains(self):
        angle, stretch = 0.3, np.diag([1.2, 0.9])
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
        points = Table({"deformation_gradient": (turn @ stretch).reshape(1, 4)})
        softgrain.state.kinematics.add_strains(points)
        e = np.array([np.log(1.2), np.log(0.9), 0])
        np.testing.assert_allclose(points["volume_strain"], e.sum())
        np.testing.assert_allclose(points["shear_strain"], (e[0] - e[1]) / 2)
        d = e - e.mean()
        np.testing.assert_allclose(points["equivalent_strain"], np.sqrt(2 / 3 * d @ d))

    def test_rows_of_one_pair_become_one(self):
        nothing = Table({name: np.zeros(0, dtype=int) for name in ("body_a", "body_b", "wall")} |
                        {name: np.zeros((0, 2)) for name in ("place_m", "normal", "force_N_per_m")})
        self.assertEqual(len(pairs_of(nothing)), 0)
        rows = Table({"body_a": np.array([0, 0, 2, 2, 0]), "body_b": np.array([-1, -1, 1, 2, 1]),
                      "wall": np.array([1, 0, -1, -1, -1]), "place_m": np.zeros((5, 2)),
                      "normal": np.tile([0., 1.], (5, 1)), "force_N_per_m": np.tile([1., 2.], (5, 1))})
        pairs = pairs_of(rows)
        found = set(zip(pairs["body_a"].tolist(), pairs["body_b"].tolist(), pairs["wall"].tolist()))
        self.assertEqual(found, {(0, -1, 0), (0, -1, 1), (0, 1, -1), (1, 2, -1)})  # not that of 2 with itself

    def test_a_run_that_goes_on(self):
        folder = os.path.join(common.WORK, "growing")
        os.makedirs(os.path.join(folder, "snapshots"))
        run = softgrain.open(folder)
        self.assertEqual((len(run), run.finished, run.summary), (0, False, None))
        for status, finished in (("running", False), ("failed", False), ("completed", True), ("running", False)):
            with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
                file.write(f'{{"status": "{status}"}}')
            self.assertEqual((run.status, run.finished), (status, finished))
        with self.assertRaisesRegex(softgrain.InputError, "Snapshots every"):
            run[-1]
        with open(os.path.join(common.EXAMPLE, "history.csv"), encoding="utf-8") as file:
            lines = file.readlines()

        def write(text, n):
            with open(os.path.join(folder, "history.csv"), "w", encoding="utf-8") as file:
                file.write(text)
            for i in range(n):
                shutil.copy(os.path.join(common.EXAMPLE, f"snapshots/{i:06d}.h5"), os.path.join(folder, "snapshots"))
            with h5py.File(os.path.join(folder, "snapshots.h5.part"), "w") as file:
                file["time_s"] = self.run_.times[:n]
                for i in range(n):
                    file[f"steps/{i:06d}"] = h5py.ExternalLink(f"snapshots/{i:06d}.h5", "/")
            os.replace(os.path.join(folder, "snapshots.h5.part"), os.path.join(folder, "snapshots.h5"))

        write("".join(lines[:5]) + lines[5][:30], 1)
        self.assertEqual((len(run.history_table), len(run), run[-1].number), (4, 1, 0))
        write("".join(lines[:9]) + lines[9].rstrip("\n")[:-1], 3)  # the last number may not be whole
        self.assertEqual((len(run.history_table), len(run), run[-1].number), (8, 3, 2))
        self.assertEqual(run[-1].time, self.run_.times[2])

    def test_names_in_pandas(self):
        """A table of pandas finds columns as one of numpy does, also one that was cut, sorted or pickled."""
        try:
            import pandas
        except ImportError:
            self.skipTest("pandas is not installed")
        table = self.run_.history
        self.assertIsInstance(table, pandas.DataFrame)
        for one in (table, table[table.step > 1], table.sort_values("dt_s"), pickle.loads(pickle.dumps(table))):
            self.assertTrue(one["top_force"].equals(one["top_force_N_per_m"]))
        with self.assertRaisesRegex(KeyError, "no 'top_forc' in this table; did you mean top_force_N_per_m"):
            table["top_forc"]

    def test_without_pandas(self):
        with mock.patch.dict(sys.modules, {"pandas": None}):
            history = self.run_.history
        self.assertIsInstance(history, Table)
        self.assertEqual(len(history["time_s"]), len(history))
        self.assertEqual(history.units["top_force_N_per_m"], "N/m")
        with mock.patch.dict(sys.modules, {"pandas": None}), self.assertRaisesRegex(softgrain.InputError, "python3-pandas"):
            history.to_pandas()

    def test_names_that_are_not_there(self):
        with self.assertRaisesRegex(softgrain.MissingName, "there is no 'colour' in bodies"):
            self.run_[-1].bodies["colour"]
        with self.assertRaisesRegex(AttributeError, "there is no 'colour'"):
            self.run_[-1].bodies.colour
        with self.assertRaisesRegex(softgrain.MissingName, "did you mean Materials/gel/Density"):
            self.run_.parameters["Density"]
        with self.assertRaisesRegex(softgrain.MissingName, "did you mean .*top_force"):
            self.run_.column("top_forse")
        with self.assertRaises(IndexError):
            self.run_[99]
        with self.assertRaisesRegex(softgrain.InputError, "there is no folder nowhere"):
            softgrain.open("nowhere")

    def test_csv_of_bodies(self):
        bodies = self.run_[-1].bodies
        bodies.to_csv("bodies.csv")
        with open("bodies.csv", encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["name"] for row in rows], ["lower", "upper"])
        for name in ("center_x_m", "center_y_m", "area_m2", "mean_stress_xy_Pa", "mean_pressure_Pa", "coordination"):
            np.testing.assert_array_equal([float(row[name]) for row in rows], bodies.flat()[name])
        self.assertFalse([name for name in os.listdir() if name.startswith(".part")])

    def test_lammps_dump(self):
        self.run_.to_lammps_dump("run.dump")
        frames = softgrain.read_lammps_dump("run.dump")
        self.assertEqual([frame["time"] for frame in frames], list(self.run_.times))
        with open("run.dump", encoding="ascii") as file:
            self.assertEqual([next(file).strip() for _ in range(5)],
                             ["ITEM: UNITS", "si", "ITEM: TIME", "0.0", "ITEM: TIMESTEP"])
        points, last = self.run_[-1].points, frames[-1]
        np.testing.assert_allclose(np.stack([last["x"], last["y"]], axis=1), points["position_m"], rtol=1e-8)
        np.testing.assert_allclose(last["vy"], points["velocity_m_per_s"][:, 1], rtol=1e-8, atol=1e-12)
        np.testing.assert_allclose(np.pi * last["radius"]**2, points["area_m2"], rtol=1e-7)
        np.testing.assert_array_equal(last["mol"], points["body"] + 1)
        low, high = last["bounds"].T
        self.assertTrue((low[:2] < points["position_m"].min(axis=0)).all())
        self.assertTrue((high[:2] > points["position_m"].max(axis=0)).all())

    def test_dump_for_others(self):
        """The reader of another program finds the same places."""
        try:
            from ase.io import read
        except ImportError:
            self.skipTest("python3-ase is not there")
        self.run_.to_lammps_dump("ase.dump")
        frames = read("ase.dump", index=":", format="lammps-dump-text")
        self.assertEqual([len(frame) for frame in frames], [len(state.points) for state in self.run_])
        np.testing.assert_allclose(frames[-1].positions[:, :2], self.run_[-1].points["position_m"], rtol=1e-8)

    def test_meshes(self):
        from vtkmodules.util.numpy_support import vtk_to_numpy
        state = self.run_[-1]
        mesh = state.to_vtk("points")
        self.assertEqual(mesh.GetNumberOfVerts(), len(state.points))
        np.testing.assert_array_equal(vtk_to_numpy(mesh.GetPointData().GetArray("von_mises_Pa")), state.points["von_mises_Pa"])
        mesh = state.to_vtk("outlines")
        self.assertEqual(mesh.GetNumberOfLines(), 2)
        np.testing.assert_array_equal(vtk_to_numpy(mesh.GetCellData().GetArray("area_m2")), state.bodies["area_m2"])
        closed = vtk_to_numpy(mesh.GetLines().GetConnectivityArray())
        self.assertEqual(closed[0], closed[len(state.outlines[0][0])])
        self.assertEqual(state.to_vtk("walls").GetNumberOfLines(), 4)
        try:
            import pyvista
        except ImportError:
            with self.assertRaisesRegex(softgrain.InputError, "pip install pyvista"):
                state.to_pyvista()
        else:
            self.assertIsInstance(state.to_pyvista(), pyvista.PolyData)
            self.assertEqual(state.to_pyvista("contacts").n_points, len(state.contacts))

    def test_xarray(self):
        try:
            import xarray  # noqa: F401
        except ImportError:
            with self.assertRaisesRegex(softgrain.InputError, "python3-xarray"):
                self.run_.to_xarray()
            return
        data = self.run_.to_xarray()
        self.assertEqual(data["body_center_m"].dims, ("time", "body", "axis"))
        self.assertEqual(data["body_area_m2"].attrs["units"], "m²")
        np.testing.assert_array_equal(data["time"], self.run_.times)
        one = self.run_[-1].to_xarray()
        self.assertEqual(one["point_stress_Pa"].sel(tensor="yy").shape, (len(self.run_[-1].points),))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
