#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""How much the outlines of bodies are compressed along themselves in the last checkpoint of runs: the least stretch of a piece between two
markers, over its length at rest. Below .65 the surface of a neo-Hookean solid creases (Hong, Zhao and Suo 2009), at .54 it wrinkles (Biot)."""
import argparse
import pathlib

import h5py
import numpy


def least_stretch(body):
    """The least stretch of a piece of the outline of @body, a group of a checkpoint."""
    now, at_rest = (body[name][:].reshape(-1, 2) for name in ("boundary_position", "boundary_grid_position"))
    return min(numpy.linalg.norm(numpy.roll(now, -1, 0) - now, axis=1) / numpy.linalg.norm(numpy.roll(at_rest, -1, 0) - at_rest, axis=1))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, nargs="+", help="of a run")
    for folder in parser.parse_args().folder:
        states = sorted(folder.glob("state-*.h5"))
        if not states:
            print(f"{folder.name}: no checkpoint")
            continue
        with h5py.File(states[-1]) as state:
            found = sorted((least_stretch(body), name) for name, body in state["mpm/bodies"].items() if "boundary_position" in body)
        print(f"{folder.name}: " + ", ".join(f"{name} {stretch:.2f}" for stretch, name in found[:3]))


if __name__ == "__main__":
    main()
