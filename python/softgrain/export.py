# SPDX-License-Identifier: LGPL-2.1-or-later
"""States and runs as xarray datasets."""

import numpy as np

from .errors import need
from .tables import COMPONENTS


def require_xarray():
    try:
        import xarray
    except ImportError as error:
        raise need("python3-xarray", error) from error
    return xarray


def variables(table, rows, prefix=""):
    """
    {name: (dimensions, values, attributes)} of a table; vectors and tensors get a dimension of
    components.
    """
    result = {}
    for name, values in table.items():
        unit = table.unit(name)
        dimensions = [rows] + [
            {2: "axis", 3: "tensor", 4: "tensor4"}.get(size, f"n{size}")
            for size in values.shape[1:]
        ]
        if values.ndim > 2:
            dimensions[1:] = [f"{rows}_{name}_{i}" for i in range(1, values.ndim)]
        result[prefix + name] = (dimensions, values, {"units": unit} if unit else {})
    return result


def coordinates():
    return {
        "axis": list(COMPONENTS[2]),
        "tensor": list(COMPONENTS[3]),
        "tensor4": list(COMPONENTS[4]),
    }


def dataset(data, attributes):
    xarray = require_xarray()
    used = {dimension for dimensions, *_ in data.values() for dimension in dimensions}
    labels = {name: values for name, values in coordinates().items() if name in used}
    return xarray.Dataset(data, coords=labels, attrs=attributes)


def state_to_xarray(state):
    """
    Bodies, points, contacts and walls of one state; names of columns have the part before them.
    """
    require_xarray()
    data = {}
    for part, rows in (
        ("bodies", "body"),
        ("points", "point"),
        ("contacts", "contact"),
        ("walls", "wall"),
    ):
        if state.has(part):
            data.update(variables(getattr(state, part), rows, f"{rows}_"))
    return dataset(data, {"time_s": state.time, "directory": state.run.directory})


def run_to_xarray(run):
    """Bodies and walls of all states along the dimension time."""
    require_xarray()
    states, data = list(run), {}
    for part, rows in (("bodies", "body"), ("walls", "wall")):
        found = [
            variables(getattr(state, part), rows, f"{rows}_") for state in states if state.has(part)
        ]
        if not found or len(found) != len(states):
            continue
        for name, (dimensions, values, attributes) in found[0].items():
            series = [other[name][1] for other in found if name in other]
            if len(series) == len(states) and all(one.shape == values.shape for one in series):
                data[name] = (["time", *dimensions], np.stack(series), attributes)
    result = dataset(data, {"directory": run.directory})
    return result.assign_coords(time=("time", run.times[: len(states)], {"units": "s"}))
