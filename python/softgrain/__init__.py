# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Results of softgrain as numpy arrays.

    import softgrain

    run = softgrain.open("output/thirty_grains_mpm")     # also while the run goes on
    run.history["packing_fraction"]                      # history.csv, a pandas table when pandas
    is there run.parameters["Contact/Friction"] run[-1].bodies.center_m
    # arrays of the last state run.plot("bottom_force_N_per_m") run[-1].plot("pressure_Pa")
    softgrain.run("scene.prm", set={"Contact/Friction": 0.3})

It needs numpy and h5py. matplotlib (pictures), VTK (fields.pvd), pandas, xarray and pyvista are
used where they are.
"""

from . import measures
from .errors import InputError, MissingName, RunFailed
from .folder import Run
from .folder import (
    open_run as open,
)  # noqa: A004  (as h5py.File and xarray.open_dataset: softgrain.open)
from .lammps import read_dump as read_lammps_dump
from .outlines import Outlines
from .programs import find_program, measure, run
from .scene import Scene
from .state import State
from .study import run_study
from .sweeps import Row, Sweep, sweep
from .tables import Table, read_table
from .units import split_unit

__version__ = "0.2.0"

__all__ = [
    "InputError",
    "MissingName",
    "Outlines",
    "Row",
    "Run",
    "RunFailed",
    "Scene",
    "State",
    "Sweep",
    "Table",
    "find_program",
    "measure",
    "measures",
    "open",
    "read_lammps_dump",
    "read_table",
    "run",
    "run_study",
    "split_unit",
    "sweep",
]
