#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs the scenes built in Python of the folder examples and draws the pictures that doc/gallery.md shows of them."""
import argparse
import os
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
from running import PARAMETERS  # noqa: E402  (it finds the package)

sys.path.insert(0, str(PARAMETERS.parent / "examples"))
import bidisperse_mixture  # noqa: E402
import hard_and_soft  # noqa: E402
import hopper  # noqa: E402
import modulus  # noqa: E402
import oscillating_wall  # noqa: E402
import shaken_box  # noqa: E402

SMALL = {"width": 4.5}  # inches: small enough for a page
RATIOS, FREQUENCIES, SHARES = (1, 3, 10), (0.3, 1, 3, 10, 30), (0.05, 0.5, 0.9)


def pictures(folder):
    """(name, figure) of every example."""
    run = bidisperse_mixture.mixture(1).run(f"{folder}/mixture_1", again=False)
    yield "bidisperse_mixture", run[-1].plot("pressure_Pa", **SMALL)
    run = hopper.hopper(2).run(f"{folder}/hopper_2", again=False)
    yield "hopper", run.at(0.2).plot(**SMALL)
    yield "hard_and_soft", hard_and_soft.draw({ratio: hard_and_soft.mixture(ratio).run(f"{folder}/hard_and_soft_{ratio}", again=False)
                                               for ratio in RATIOS})
    yield "shaken_box", shaken_box.draw({share: shaken_box.box(share).run(f"{folder}/shaken_{share:g}", again=False) for share in SHARES})
    yield "modulus", modulus.draw(modulus.study(f"{folder}/modulus"))
    yield "oscillating_wall", oscillating_wall.draw({
        frequency: oscillating_wall.block(frequency).run(f"{folder}/swing_{frequency:g}", again=False) for frequency in FREQUENCIES})


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("--folder", default="output/examples", help="for the output folders of the runs (default: %(default)s)")
    parser.add_argument("--pictures", type=pathlib.Path, default=PARAMETERS.parent / "doc/pictures/gallery",
                        help="where the pictures go (default: doc/pictures/gallery)")
    arguments = parser.parse_args()
    os.environ["SOFTGRAIN"] = arguments.program
    for name, figure in pictures(arguments.folder):
        path = arguments.pictures / f"example_{name}.png"
        figure.savefig(path, dpi=110)
        print(path, flush=True)


if __name__ == "__main__":
    main()
