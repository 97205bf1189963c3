# SPDX-License-Identifier: LGPL-2.1-or-later
"""What the scripts of this folder share: a scene is run with some parameters changed, and what it wrote is read."""
import argparse
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PARAMETERS = ROOT / "parameters"
PYTHON = ROOT / "python"
sys.path.insert(0, str(PYTHON))

import softgrain  # noqa: E402
from softgrain import RunFailed  # noqa: E402


def parser_of(description, name):
    """What scripts are told: the program, and the folder for their runs, output/NAME by default. @description: that of the script"""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output") / name,
                        help="for the output folders of the runs (default: %(default)s)")
    return parser


def read_run(folder):
    """summary.json, and history.csv as a list of rows {column: number, nan where there is none}."""
    found = softgrain.open(folder)
    return found.summary, rows_of(found)


def rows_of(found):
    """The history of an opened run as a list of rows."""
    return as_rows(found.history_table)


def as_rows(table):
    """A table of columns as a list of rows."""
    return [dict(zip(table, row)) for row in zip(*(table[name].tolist() for name in table))]


def run(program, scene, folder, changes, threads=0, limit=None, again=True, prepared=None):
    """Runs @scene (below parameters/) with @changes {"Section/Name": value} into @folder; summary and history as
    read_run(). With again=False a finished run that is there already is only read. @limit: seconds it may take. @prepared: the
    checkpoint it goes on from."""
    try:
        done = softgrain.run(PARAMETERS / scene, set=changes, output=str(folder), threads=threads, program=str(program),
                             timeout=limit, again=again, restart=prepared, overwrite=prepared is None, verbose=True)
    except softgrain.InputError as error:
        raise RunFailed(str(error)) from error
    if done.log is not None:
        pathlib.Path(folder, "log").write_text(done.log, encoding="utf-8")
    return read_run(folder)


def run_all(program, folder, cases, threads=0):
    """Runs @cases (name, scene, changes, the checkpoint it goes on from or None) into folders of these names, and gives (name, changes,
    summary, rows) of each. One that is there already is only read; one that fails is named and left out."""
    for name, scene, changes, prepared in cases:
        try:
            summary, rows = run(program, scene, pathlib.Path(folder) / name, changes, threads, again=False, prepared=prepared)
        except RunFailed as trouble:
            print(f"{name}: {trouble}", file=sys.stderr, flush=True)
            continue
        yield name, changes, summary, rows


def box(number, usual, width, height):
    """Parameters of a box of @number grains that has as much room for each as one of @usual in @width times @height; its width and height [m]."""
    scale = (number / usual) ** 0.5
    width, height = scale * width, scale * height
    return {"Packing/Number": number, "Packing/Upper": f"{width:.6g}, {height:.6g}", "Walls/top/Point": f"0, {height:.6g}",
            "Walls/right/Point": f"{width:.6g}, 0"}, width, height
