# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables that decks for other codes read and write."""
import csv


def read_grains(path):
    """(x, y, radius) of every disk of a packing, from the columns x_m, y_m, radius_m."""
    with open(path, encoding="utf-8") as file:
        return [(float(row["x_m"]), float(row["y_m"]), float(row["radius_m"])) for row in csv.DictReader(file)]


def write(lines, path):
    """Lines into a file, or to the screen where it is None."""
    text = "\n".join(lines) + "\n"
    if path:
        path.write_text(text, encoding="utf-8")
    else:
        print(text, end="")
