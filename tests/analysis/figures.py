# SPDX-License-Identifier: LGPL-2.1-or-later
"""
softgrain.figures.thesis_4 on runs that follow the laws of Nguyen (2016) exactly: it must find their constants again.

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

from softgrain import fits  # noqa: E402

INITIAL, REFERENCE, REFERENCE_STRESS, WIDTH = 0.7, 0.8, 2.5e5, 0.04
BINS = np.arange(0.1, 4, 0.2)


def write_table(path, columns):
    with open(path, "w", encoding="utf-8") as file:
        file.write(",".join(columns) + "\n")
        for row in zip(*columns.values()):
            file.write(",".join("" if np.isnan(value) else f"{value:.10g}" for value in row) + "\n")


def broken_line(packing, first, second, slopes):
    return (slopes[0] * packing + (slopes[1] - slopes[0]) * np.maximum(packing - first, 0)
            + (slopes[2] - slopes[1]) * np.maximum(packing - second, 0))


def write_snapshots(directory, times, height):
    """One square body between four walls that shrinks with the box."""
    with h5py.File(os.path.join(directory, "snapshots.h5"), "w") as file:
        file["time_s"] = times
        for index, h in enumerate(height):
            group = file.create_group(f"steps/{index:06d}")
            group["outlines/points_m"] = np.array([[0, 0], [WIDTH, 0], [WIDTH, h], [0, h]]) * 0.9
            group["outlines/ring_offsets"] = np.array([0, 4])
            group["outlines/body_offsets"] = np.array([0, 1])
            group["points/position_m"] = np.array([[WIDTH / 2, h / 2]])
            group["points/area_m2"] = np.array([1e-6])
            group["points/body"] = np.array([0])
            group["walls/name"] = np.array([b"bottom", b"top", b"left", b"right"])
            group["walls/position_m"] = np.array([0, h, 0, WIDTH])


def write_run(name, model, friction, beta=None, alpha=None, exponent=0.5, gamma=0.2, measures=True):
    """A compaction to 0.97 whose stress follows (4.3) with @beta, or (4.1) with @alpha."""
    directory = os.path.join(WORK, name)
    os.makedirs(directory)
    with open(os.path.join(directory, "parameters.prm"), "w", encoding="utf-8") as file:
        file.write(f"set Model = {model}\nsubsection Contact\n  set Friction = {friction}\nend\n")
    strain = np.linspace(0, np.log(0.97 / INITIAL), 2000)
    packing = INITIAL * np.exp(strain)
    height = 0.03 * np.exp(-strain)
    if beta:
        stress = 1 + beta * (strain - np.log(REFERENCE / INITIAL))
    else:
        stress = 1 - np.log((1 - packing) / (1 - REFERENCE)) / alpha
    stress = REFERENCE_STRESS * np.maximum(stress, 0)
    time = np.linspace(0, 1e-3, len(strain))
    write_table(os.path.join(directory, "history.csv"), {
        "time_s": time, "step": np.arange(len(time)), "bottom_force_N_per_m": stress * WIDTH,
        "left_position_m": 0 * time - 0.01, "right_position_m": 0 * time - 0.01 + WIDTH, "axial_strain": strain,
        "packing_fraction": packing})
    chosen = np.arange(0, len(time), 20)
    if measures:
        p = packing[chosen]
        coordination = np.where(p > REFERENCE,
                                3.5 + 2 * (np.maximum(p - REFERENCE, 0) / (1 - REFERENCE))**exponent,
                                3.5 + 10 * (p - REFERENCE))
        columns = {
            "time_s": time[chosen], "step": chosen, "coordination_of_bodies": coordination,
            "specific_contact_surface": broken_line(p, 0.78, 0.95, (0.2, 1, 3)), "packing_fraction": p,
            "orientation_anisotropy": 0.3 + 0 * p, "aspect_ratio": 1 + 0.2 * p, "shape_strain": 0.1 * p,
            "shape_anisotropy": broken_line(p, 0.775, 0.925, (0, 0.2, 0.6)), "force_fit_gamma": gamma + 0 * p}
        for force in BINS:
            columns[f"force_density_at_{force:.1f}"] = fits.force_density(force, gamma) + 0 * p
        write_table(os.path.join(directory, "measures.csv"), columns)
    write_snapshots(directory, time[chosen], height[chosen])
    return directory


class Figures(unittest.TestCase):
    def test_constants_of_the_thesis_are_found_again(self):
        runs = [write_run("mpm", "mpm", 0, beta=10, gamma=0.15),
                write_run("mpm2", "mpm", 0, beta=12, gamma=0.15),
                write_run("mpm_friction", "mpm", 0.5, beta=8, exponent=0.7),
                write_run("bpm", "bpm", 0, alpha=0.27, gamma=0.25)]
        code, printed, errors = run("figures.py", "thesis-4", *runs, "--output", os.path.join(WORK, "figures"), "--dpi",
                                    "40")
        self.assertEqual((code, errors), (0, ""))
        self.assertNotIn("left out", printed)
        for number in ("4.1", "4.2", "4.3", "4.4", "4.5", "4.8", "4.9", "4.10", "4.11"):
            self.assertGreater(os.path.getsize(os.path.join(WORK, f"figures/fig-{number}.png")), 4000)
        with open(os.path.join(WORK, "figures/constants.json"), encoding="utf-8") as file:
            numbers = json.load(file)
        self.assertEqual(numbers["thesis"]["beta"], {"mpm": 10, "bpm": None})
        self.assertEqual([(group["model"], group["friction"], len(group["runs"])) for group in numbers["groups"]],
                         [("mpm", 0, 2), ("mpm", 0.5, 1), ("bpm", 0, 1)])
        smooth, rough, bonded = (group["mean"] for group in numbers["groups"])
        near = self.assertAlmostEqual
        near(smooth["beta"], 11, delta=0.02)
        near(numbers["groups"][0]["spread"]["beta"], np.sqrt(2), delta=0.02)
        self.assertIsNone(numbers["groups"][1]["spread"]["beta"])
        near(rough["beta"], 8, delta=0.02)
        near(bonded["alpha"], 0.27, delta=1e-3)
        self.assertLess(bonded["alpha_rms"], 1e-4)
        self.assertGreater(smooth["alpha_rms"], 1e-3)  # this is not its law
        for group in (smooth, rough, bonded):
            near(group["initial_packing"], 0.7, delta=1e-6)
            near(group["reference_stress_Pa"], REFERENCE_STRESS, delta=2e-3 * REFERENCE_STRESS)
            near(group["coordination_when_full"], 5.5, delta=0.03)
            near(group["jamming_packing"], 0.75, delta=1e-4)
            near(group["jamming_strain"], np.log(0.75 / 0.7), delta=1e-4)
            near(group["first_regime_ends"], 0.775, delta=0.006)
            near(group["second_regime_ends"], 0.925, delta=0.006)
        near(smooth["coordination_at_reference"], 3.5, delta=0.02)
        near(smooth["coordination_exponent"], 0.5, delta=0.02)
        near(rough["coordination_exponent"], 0.7, delta=0.02)
        near(smooth["force_gamma"], 0.15, delta=1e-9)
        # Phi - Phi0 against stress bends a little, since (4.5) is (4.4) cut off.
        near(rough["packing_slope"], slope_of_4_4(8), delta=2e-3)
        self.assertIn("| β (4.3)", printed)
        self.assertIn("11 ± 1.4", printed)

    def test_poor_fits_are_told(self):
        # By MPM, but its stress stays low and then rises steeply: no line, which (4.3) is.
        bent = write_run("bent", "mpm", 0, alpha=0.02)
        history = os.path.join(bent, "history.csv")
        with open(history, encoding="utf-8") as file:
            names, *rows = [line.rstrip("\n").split(",") for line in file]
        force, packing = names.index("bottom_force_N_per_m"), names.index("packing_fraction")
        for row in rows:
            row[force] = str(REFERENCE_STRESS * WIDTH * (1 + 5 * max(0., float(row[packing]) - 0.93) * 1e3))
        write_table(history, {name: np.array([float(row[i]) for row in rows]) for i, name in enumerate(names)})
        code, printed, errors = run("figures.py", "thesis-4", bent, "--output", os.path.join(WORK, "bent_figures"), "--only",
                                    "4.2", "--dpi", "40")
        self.assertEqual(code, 0)
        self.assertIn("constants.json", printed)
        self.assertRegex(errors, r"figures thesis-4: warning: β \(4.3\) of .*bent fits poorly, R² = 0\.\d\d")
        with open(os.path.join(WORK, "bent_figures/constants.json"), encoding="utf-8") as file:
            quality = json.load(file)["groups"][0]["runs"][0]["r_squared"]
        self.assertLess(quality["beta"], 0.9)
        self.assertGreater(quality["coordination_exponent"], 0.99)

    def test_what_is_missing_is_said(self):
        bare = write_run("bare", "bpm", 0, alpha=0.3, measures=False)
        code, printed, errors = run("figures.py", "thesis-4", bare, "--output", os.path.join(WORK, "bare_figures"),
                                    "--format", "svg",
                                    "--only", "4.3", "4.8")
        self.assertEqual((code, errors), (0, ""))
        self.assertIn("figure 4.8 is left out: no run has the measure 'contact_surface'", printed)
        self.assertTrue(os.path.exists(os.path.join(WORK, "bare_figures/fig-4.3.svg")))
        other = os.path.join(WORK, "other")
        os.makedirs(other)
        write_table(os.path.join(other, "history.csv"), {"time_s": [0., 1.], "step": [0, 1]})
        for arguments, words in (([other], "is no compaction"), (["nowhere"], "there is no folder"),
                                 ([bare, "--only", "4.6"], "4.6"),
                                 ([bare, "--reference", "2"], "--reference")):
            code, _, errors = run("figures.py", "thesis-4", *arguments)
            self.assertEqual((code, len(errors.splitlines())), (2, 1), errors)
            self.assertIn(words, errors)


def slope_of_4_4(beta):
    """Slope of packing against stress over the reference, least squares, of (4.3) with Phi = Phi0 exp(strain)."""
    packing = np.linspace(REFERENCE, 0.97, 1000)
    stress = beta * np.log(packing / REFERENCE)
    return np.dot(stress, packing - REFERENCE) / np.dot(stress, stress)


if __name__ == "__main__":
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(WORK)
    unittest.main(argv=sys.argv[:1])
