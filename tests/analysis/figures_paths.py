# SPDX-License-Identifier: LGPL-2.1-or-later
"""
softgrain.figures.thesis_5 on paths that follow the laws of Nguyen (2016), chapter 5, exactly: it must find their constants again.

Arguments: PYTHON_DIR WORK.
"""

import json
import os
import shutil
import sys
import unittest

WORK = os.path.abspath(sys.argv[2])
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "output"))

from tool_runs import run  # noqa: E402  (before matplotlib and the tools)

import h5py  # noqa: E402
import numpy as np  # noqa: E402

STIFFNESS = 100 / 0.1e-3  # F0/<a0> of primaries that are all alike [Pa]


def write_table(path, columns):
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join("" if np.isnan(value) else f"{value:.10g}" for value in row) + "\n")


def write_snapshots(directory, times, strain, band):
    """Grains on a lattice that is sheared, all alike or, with @band, only in the upper half."""
    x, y = (part.ravel() for part in np.meshgrid(np.arange(6) + 0.5, np.arange(6) + 0.5))
    with h5py.File(os.path.join(directory, "snapshots.h5"), "w") as file:
        file["time_s"] = times
        for index, e in enumerate(strain):
            group = file.create_group(f"steps/{index:06d}")
            down = np.where(y > 3, 3 + (y - 3) * np.exp(-e), y) if band else y * np.exp(-e / 2)
            group["bodies/center_m"] = np.stack([x * np.exp(0 if band else e / 2), down], axis=1)
            corners = group["bodies/center_m"][:][:, None] + 0.4 * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
            group["outlines/points_m"] = corners.reshape(-1, 2)
            group["outlines/ring_offsets"] = 4 * np.arange(37)
            group["outlines/body_offsets"] = np.arange(37)
            group["points/position_m"] = np.stack([x, y], axis=1)
            group["points/area_m2"] = np.full(36, 0.5)
            group["points/body"] = np.arange(36)
            group["walls/name"] = np.array([b"bottom", b"top", b"left", b"right"])
            group["walls/position_m"] = np.array([0, 6, 0, 6.])


def write_path(name, kappa, unload=False, model="bpm", friction=0, close=False, grains=None, law=""):
    """Isotropic to t = 1, sheared to 0.8 at t = 2 with q/p to 0.3, back to 0.4 at t = 3; strains begin at 0.5.
    With @close the walls are driven until t = 0.5 before they are pressed, and their stress at t = 1 is not quite what is asked."""
    directory = os.path.join(WORK, name)
    os.makedirs(directory)
    stages = ("close, " if close else "") + "compact, shear" + (", back" if unload else "")
    drives = "".join(f"  subsection {stage}\n    subsection top\n      set Drive = velocity\n    end\n  end\n"
                     for stage in (*(["close"] if close else []), "shear", *(["back"] if unload else [])))
    if close:
        drives += "  subsection compact\n" + "".join(
            f"    subsection {wall}\n      set Drive = pressure\n      set Pressure = {kappa * STIFFNESS}\n    end\n"
            for wall in ("top", "right")) + "  end\n"
    with open(os.path.join(directory, "parameters.prm"), "w", encoding="utf-8") as file:
        file.write(f"set Model = {model}\nsubsection Contact\n  set Friction = {friction}\nend\nsubsection Materials\n"
                   f"  subsection grain\n{law}    subsection Power law\n      set Force at contact = 100\n    end\n"
                   f"    subsection Neo-Hookean\n      set Young's modulus = {STIFFNESS}\n    end\n  end\nend\n"
                   "subsection Primaries\n  set Smallest diameter = 1e-4\n  set Largest diameter = 1e-4\nend\n"
                   f"subsection Stages\n  set Names = {stages}\n{drives}end\n")
    if grains:
        with open(os.path.join(directory, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({"status": "completed", "bodies": grains}, file)
    time = np.linspace(0, 3 if unload else 2, 301 if unload else 201)
    stage = np.ceil(np.maximum(time, 0.001) - 1e-9) + (close & (time > 0.5))
    write_table(os.path.join(directory, "history.csv"), {"time_s": time, "step": np.arange(len(time)), "stage": stage})
    strain = np.where(time < 1, 0, np.where(time < 2, 0.8 * (time - 1), 0.8 - 0.4 * (time - 2)))
    ratio = np.where(time <= 2, 0.3 * (1 - np.exp(-strain / 0.05)), -0.2)
    p = kappa * STIFFNESS / (1 - ratio)
    logarithm, ones = np.log10(kappa), np.ones(len(time))
    write_table(os.path.join(directory, "measures.csv"), {
        "time_s": time, "step": np.arange(len(time)), "packing_fraction": (0.93 + 0.13 * logarithm) * ones,
        "void_ratio": (0.08 - 0.15 * logarithm) * ones, "coordination_of_bodies": (4.8 + 1.1 * logarithm) * ones,
        "strain_1": 0.5 + strain / 2, "strain_2": -strain / 2, "shear_strain": 0.5 + strain, "volume_strain": 0.5 * ones,
        "stress_2_Pa": (1.1 if close else 1.) * kappa * STIFFNESS * ones, "wall_pressure_Pa": p, "wall_deviator_Pa": ratio * p,
        "wall_stress_ratio": ratio, "half_sum_of_anisotropies": ratio, "predicted_stress_ratio": ratio + 0.01,
        **{column: 0.1 * ones for column in ("specific_contact_surface", "shape_strain", "shape_anisotropy",
                                             "contact_anisotropy", "normal_force_anisotropy")}})
    chosen = [100, 125, 162, 200]
    write_snapshots(directory, time[chosen], strain[chosen], band=friction > 0)
    return directory


class Figures(unittest.TestCase):
    def test_constants_of_the_thesis_are_found_again(self):
        runs = [write_path(f"bpm-{kappa}", kappa, unload=kappa == 0.4, close=kappa == 1.6) for kappa in (0.2, 0.4, 1.6)]
        runs += [write_path("mpm", 0.05, model="mpm", friction=0.5)]
        code, printed, errors = run("figures.py", "thesis-5", *runs, "--output", os.path.join(WORK, "figures"), "--dpi", "40")
        self.assertEqual((code, errors), (0, ""))
        self.assertNotIn("left out", printed)
        for number in ("5.2", "5.3", "5.4", "5.5", "5.7", "5.8", "5.9", "5.10", "5.11", "5.12", "5.13", "5.16", "5.17", "5.18",
                       "5.19", "5.20", "5.21", "5.22", "5.23", "bands"):
            self.assertGreater(os.path.getsize(os.path.join(WORK, f"figures/fig-{number}.png")), 3000)
        with open(os.path.join(WORK, "figures/constants.json"), encoding="utf-8") as file:
            numbers = json.load(file)
        bonded, soft = numbers["groups"]
        self.assertEqual((bonded["model"], soft["model"], soft["friction"]), ("bpm", "mpm", 0.5))
        for name, value in (("packing_at_stiffness", 0.93), ("packing_slope", 0.13), ("void_ratio_at_stiffness", 0.08),
                            ("void_ratio_slope", 0.15), ("coordination_at_stiffness", 4.8), ("coordination_slope", 1.1),
                            ("slope_of_5_5", 1.1 / 0.15)):
            self.assertAlmostEqual(bonded["constants"][name], value, delta=1e-6)
            self.assertIsNone(soft["constants"][name])  # of one pressure
        for path in bonded["runs"]:
            self.assertAlmostEqual(path["steady_stress_ratio"][0], 0.3, delta=1e-3)
        for run_of_group, kappa in zip(bonded["runs"], (0.2, 0.4, 1.6)):
            self.assertAlmostEqual(run_of_group["kappa"], kappa, delta=1e-9)
        # (5.16) holds exactly without friction; with it the prediction is 0.01 too large.
        lines = [line for line in printed.splitlines() if line.startswith(("| BPM", "| MPM"))]
        self.assertEqual([line.split("|")[-2].strip() for line in lines], ["0.000", "0.000", "0.000", "0.010"])

    def test_stiffness_is_that_of_the_law(self):
        """p_I = F0/<a0> with F0 of the law that the material names, whatever other sections say."""
        from softgrain.figures import thesis_5
        potential = "    set Law = power_potential\n    subsection Power potential\n      set Characteristic force = 200\n    end\n"
        for law, kappa in (("", 0.4), ("    set Law = power_law\n", 0.4), (potential, 0.2), (potential.replace("_potential", "_law", 1), 0.4)):
            with self.subTest(law=law):
                path = thesis_5.read_path(write_path(f"law-{len(os.listdir(WORK))}", 0.4, law=law))
                self.assertAlmostEqual(path.kappa, kappa, delta=1e-9)

    def test_too_few_pressures_are_not_fitted(self):
        # 0.4 and 0.41 are one pressure; runs of another number of grains are no places of the same line.
        runs = [write_path(f"few-{kappa}", kappa, grains=30) for kappa in (0.2, 0.4, 0.41)]
        runs += [write_path(f"many-{kappa}", kappa, grains=100) for kappa in (0.2, 0.4, 1.6)]
        folder = os.path.join(WORK, "few")
        code, printed, errors = run("figures.py", "thesis-5", *runs, "--output", folder, "--only", "5.2", "5.5", "--dpi", "40")
        self.assertEqual((code, errors), (0, ""))
        self.assertEqual([line for line in printed.splitlines() if "fitted" in line],
                         ["BPM, 30 grains: (5.2)-(5.5) are not fitted, 2 pressures, and a fit needs 3"])
        self.assertEqual([line.split("|")[1].strip() for line in printed.splitlines() if line.startswith("| BPM")],
                         3 * ["BPM, 30 grains"] + 3 * ["BPM, 100 grains"])
        with open(os.path.join(folder, "constants.json"), encoding="utf-8") as file:
            few, many = json.load(file)["groups"]
        self.assertEqual((few["grains"], many["grains"]), (30, 100))
        self.assertEqual(set(few["constants"].values()), {None})
        self.assertAlmostEqual(many["constants"]["packing_slope"], 0.13, delta=1e-6)

    def test_shear_between_centres(self):
        from softgrain.figures import thesis_5
        before = np.array([[0., 0.], [1., 0.], [0., 1.], [1., 1.]])
        _, shear = thesis_5.local_shear(before, before * np.exp([0.1, -0.2]))
        self.assertTrue(np.allclose(shear, 0.3))
        turned = before @ np.array([[0.6, 0.8], [-0.8, 0.6]])
        self.assertTrue(np.allclose(thesis_5.local_shear(before, turned)[1], 0))

    def test_what_is_missing_is_said(self):
        other = os.path.join(WORK, "other")
        os.makedirs(other)
        write_table(os.path.join(other, "history.csv"), {"time_s": [0., 1.], "step": [0, 1]})
        with open(os.path.join(other, "parameters.prm"), "w", encoding="utf-8") as file:
            file.write("set Model = mpm\n")
        for arguments, words in (([other], "has no stages"), (["nowhere"], "there is no folder"),
                                 ([other, "--only", "5.6"], "5.6"), ([other, "--dpi", "1"], "--dpi")):
            code, _, errors = run("figures.py", "thesis-5", *arguments)
            self.assertEqual((code, len(errors.splitlines())), (2, 1), errors)
            self.assertIn(words, errors)


if __name__ == "__main__":
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(WORK)
    unittest.main(argv=sys.argv[:1])
