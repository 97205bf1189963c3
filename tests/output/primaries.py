# SPDX-License-Identifier: LGPL-2.1-or-later
"""
render.py on two made-up bodies of primaries: where the forces are drawn, how wide, in which colours.

Arguments: PYTHON_DIR WORK.
"""

import os
import shutil
import sys
import unittest

WORK = os.path.abspath(sys.argv[2])

from tool_runs import run  # noqa: E402  (before matplotlib and the tools)

import matplotlib.image  # noqa: E402
import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402
from matplotlib.colors import to_rgb  # noqa: E402

import render  # noqa: E402
from softgrain import Table, primaries  # noqa: E402
from vtu import write_grid, write_series  # noqa: E402

# Three primaries of body 0 and one of body 1. [m]
CENTERS = np.array([[0, 0], [2, 0], [0, 3], [2, 2.5]]) * 1e-3
RADII = np.array([1, 1, 1, 1.5]) * 1e-3
BODY = np.array([0, 0, 0, 1])
# Primaries a and b, force [N/m]: touching, apart, of two bodies; the wall below as -1.
PAIRS = ((0, 1, 500.), (0, 2, -100.), (1, 3, 1000.), (0, -1, 200.))


def contacts_of(centers, radii, body, pairs, inner_length=True):
    """Contacts as the model writes them."""
    rows = {name: [] for name in ("body_a", "body_b", "wall", "normal", "force_N_per_m", "normal_force_N_per_m",
                                  "gap_m", "length_m")}
    places = []
    for a, b, force in pairs:
        if b >= 0:
            branch = centers[a] - centers[b]
            distance = np.linalg.norm(branch)
            normal, gap = branch / distance, distance - radii[a] - radii[b]
            length = distance if body[a] == body[b] else radii[a] + radii[b]
        else:
            normal, gap, length = np.array([0., 1.]), 2e-5, 2 * radii[a]
        places.append(centers[a] - (radii[a] + 0.5 * gap) * normal)
        for name, value in (("body_a", body[a]), ("body_b", body[b] if b >= 0 else -1), ("wall", -1 if b >= 0 else 0),
                            ("normal", [*normal, 0]), ("force_N_per_m", [*force * normal, 0]),
                            ("normal_force_N_per_m", force), ("gap_m", gap), ("length_m", length)):
            rows[name].append(value)
    return np.array(places), {name: np.array(values, dtype=float) for name, values in rows.items()}


def contact_table(places, rows):
    """The same as a table of a state."""
    return Table({"place_m": places, **{name: values[:, :2] if values.ndim == 2 else
                                        values.astype(int) if name.startswith("body") else values
                                        for name, values in rows.items()}})


def write_run(name, pairs, with_radii=True):
    directory = os.path.join(WORK, name)
    fields = os.path.join(directory, "fields")
    os.makedirs(fields)
    data = {"body": BODY, "area_m2": np.pi * RADII**2, "von_mises_Pa": np.array([1., 2., 3., 4.])}
    if with_radii:
        data["radius_m"] = RADII
    write_grid(os.path.join(fields, "points-0.vtu"), CENTERS, point_data=data)
    places, rows = contacts_of(CENTERS, RADII, BODY, pairs)
    write_grid(os.path.join(fields, "contacts-0.vtu"), places, point_data=rows)
    boxes = np.array([[-1, -1, 3, 4], [0.5, 1, 3.5, 4]]) * 1e-3
    vertices = np.concatenate([[[x0, y0], [x1, y0], [x1, y1], [x0, y1]] for x0, y0, x1, y1 in boxes])
    center = np.column_stack([boxes[:, 0] + boxes[:, 2], boxes[:, 1] + boxes[:, 3], np.zeros(2)]) / 2
    write_grid(os.path.join(fields, "outlines-0.vtu"), vertices, [[0, 1, 2, 3, 0], [4, 5, 6, 7, 4]], cell_data={
        "body": [0, 1], "ring": [0, 0], "center_m": center, "area_m2": [20e-6, 9e-6]})
    write_series(directory, [0.], ("points", "outlines", "contacts"))
    return directory


def share(image, colour):
    """How much of a picture has a colour."""
    return np.mean(np.abs(image[..., :3] - to_rgb(colour)).max(axis=2) < 0.02)


class Primaries(unittest.TestCase):
    def picture(self, *arguments):
        code, printed, errors = run("render.py", *arguments, "--dpi", "80")
        self.assertEqual((code, errors), (0, ""))
        path = printed.split()[-1]
        if path.endswith(".svg"):
            with open(path, encoding="utf-8") as file:
                return file.read()
        return matplotlib.image.imread(path)

    def test_lines_join_centres(self):
        places, rows = contacts_of(CENTERS, RADII, BODY, PAIRS)
        contacts = contact_table(places, rows)
        points = Table({"position_m": CENTERS, "body": BODY, "radius_m": RADII})
        lines, forces, on_wall = primaries.force_lines(contacts, points)
        np.testing.assert_array_equal(lines[:3], [CENTERS[[a, b]] for a, b, _ in PAIRS[:3]])
        np.testing.assert_allclose(lines[3], [[0, 0], [0, -1.02e-3]], atol=1e-12)
        np.testing.assert_array_equal(forces, [force for *_, force in PAIRS])
        np.testing.assert_array_equal(on_wall, [False, False, False, True])
        # Without radii: half the length to both sides, which is right where the radii are equal.
        lines = primaries.force_lines(contacts)[0]
        np.testing.assert_allclose(lines[:2], [CENTERS[[a, b]] for a, b, _ in PAIRS[:2]], atol=1e-12)
        np.testing.assert_allclose(lines[2], CENTERS[[1, 3]] + [[0, -0.25e-3], [0, -0.25e-3]], atol=1e-12)

    def test_centres_in_a_crowd(self):
        random = np.random.default_rng(3)
        x, y = np.meshgrid(np.arange(25.), np.arange(25.))
        centers = 1.7 * np.stack([x.ravel(), y.ravel()], axis=1) + random.uniform(-0.3, 0.3, (625, 2))
        radii, body = random.uniform(0.5, 1, 625), (x.ravel() // 5).astype(int)
        pairs = [(a, b, 1.) for a in range(625) for b in (a + 1, a + 25, a + 26) if b < 625 and b % 25 >= a % 25]
        places, rows = contacts_of(centers, radii, body, pairs)
        rows = {name: values.astype(np.float32).astype(float) for name, values in rows.items()}  # as in the file
        points = Table({"position_m": centers, "body": body, "radius_m": radii})
        lines = primaries.force_lines(contact_table(places, rows), points)[0]
        np.testing.assert_array_equal(lines, [centers[[a, b]] for a, b, _ in pairs])

    def test_widths(self):
        axes = plt.figure().add_subplot()
        forces, lines = np.array([100., -50., 400., 1e4, 0.]), np.zeros((5, 2, 2))
        primaries.draw_force_lines(axes, lines, forces, np.zeros(5, dtype=bool), 0.01, 8., True)
        repulsion, attraction = [collection.get_linewidths() for collection in axes.collections
                                 if len(collection.get_segments())]
        np.testing.assert_allclose(repulsion, [1, 4, 8])
        np.testing.assert_allclose(attraction, [0.01 * 50 * primaries.THINNER])
        plt.close("all")
        self.assertAlmostEqual(primaries.full_force(np.append(np.arange(1., 1001), -5000)), 995, delta=0.1)
        self.assertEqual(primaries.full_force(np.array([-1.])), 0)

    def test_colours_of_neighbours_differ(self):
        n = 12  # a triangular lattice of bodies
        pairs = {(a, b) for a in range(n * n) for b in (a + 1, a + n, a + n + 1)
                 if b < n * n and b % n >= a % n}
        for n_colours in (6, 9):  # greedy needs one more than the bodies numbered before that are close
            numbers = primaries.colour_numbers(n * n, pairs, n_colours)
            self.assertTrue(all(numbers[a] != numbers[b] for a, b in pairs))
            self.assertEqual(set(numbers), set(range(n_colours)))

    def test_pictures(self):
        bodies = write_run("bodies", PAIRS)
        image = self.picture(bodies)
        self.assertTrue(os.path.exists(os.path.join(bodies, "pictures/body-000000.png")))
        for colour, least in ((primaries.PALETTE[0], 0.15), (primaries.PALETTE[1], 0.1), (primaries.REPULSION, 0.01),
                              (primaries.ATTRACTION, 1e-4)):
            self.assertGreater(share(image, colour), least, colour)
        image = self.picture(bodies, "--no-attraction")
        self.assertEqual(share(image, primaries.ATTRACTION), 0)
        self.assertGreater(share(image, primaries.REPULSION), 0.01)
        svg = self.picture(bodies, "--output", os.path.join(WORK, "a.svg"))
        self.assertIn("repulsion 500 N/m", svg)
        self.assertIn("attraction 100 N/m", svg)
        self.assertIn("force 500 N/m", self.picture(bodies, "--no-attraction", "--output", os.path.join(WORK, "b.svg")))
        self.assertEqual(share(self.picture(bodies, "--contacts", "none"), primaries.REPULSION), 0)
        self.assertGreater(share(self.picture(bodies, "--contacts", "chains"), primaries.REPULSION), 0.003)
        self.assertGreater(share(self.picture(bodies, "--field", "none"), primaries.REPULSION), 0.01)
        image = self.picture(bodies, "--field", "von_mises_Pa")
        self.assertEqual(share(image, primaries.PALETTE[0]) + share(image, primaries.REPULSION), 0)
        first = plt.get_cmap("tab10").colors[0]
        self.assertGreater(share(self.picture(bodies, "--colours", "tab10"), first), 0.15)
        # Without forces inside the bodies those between them are drawn as for any model.
        bare = write_run("bare", PAIRS[2:])
        self.assertEqual(share(self.picture(bare), primaries.REPULSION), 0)
        self.assertGreater(share(self.picture(bare, "--contacts", "inner"), primaries.REPULSION), 0.005)

    def test_material_points_by_body(self):
        solid = write_run("solid", PAIRS[2:], with_radii=False)
        self.picture(solid)
        self.assertTrue(os.path.exists(os.path.join(solid, "pictures/von_mises_Pa-000000.png")))
        self.assertGreater(share(self.picture(solid, "--field", "body"), primaries.PALETTE[0]), 0.15)

    def test_refused(self):
        bodies, solid = write_run("bodies2", PAIRS), write_run("solid2", PAIRS[2:], with_radii=False)
        for arguments, words in (((bodies, "--field", "von_mises_Pa", "--attraction"), "--attraction"),
                                 ((bodies, "--field", "body", "--range", "0", "1"), "--range"),
                                 ((bodies, "--colours", "grue"), "grue"),
                                 ((solid, "--contacts", "inner"), "primaries")):
            code, _, errors = run("render.py", *arguments)
            self.assertEqual((code, len(errors.splitlines())), (2, 1), errors)
            self.assertIn(words, errors)


if __name__ == "__main__":
    shutil.rmtree(WORK, ignore_errors=True)
    os.makedirs(WORK)
    unittest.main(argv=sys.argv[:1])
