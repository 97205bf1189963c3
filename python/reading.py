# SPDX-License-Identifier: LGPL-2.1-or-later
"""Reads what softgrain writes: history.csv, parameters.prm, fields.pvd with its VTU files."""

import argparse
import csv
import os
import re
import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field


class InputError(Exception):
    """What the user asked for cannot be done: one clear line, exit code 2."""


class Parser(argparse.ArgumentParser):
    """Its errors are one line, as all others, without the list of options."""

    def error(self, message):
        raise InputError(f"{message} (--help lists the options)")


def need(package, error):
    """The error for a missing Python package, naming Debian's."""
    return InputError(f"Debian's package {package} is needed: apt install {package} ({error})")


try:
    import numpy as np
except ImportError as missing:  # told as one line by whoever runs us
    print(f"{os.path.basename(sys.argv[0])}: {need('python3-numpy', missing)}", file=sys.stderr)
    sys.exit(2)


def run_tool(main):
    """Runs a command-line tool: errors of the input are one line and exit code 2."""
    name = os.path.splitext(os.path.basename(sys.argv[0]))[0]
    try:
        sys.exit(main())
    except InputError as error:
        print(f"{name}: {error}", file=sys.stderr)
        sys.exit(2)
    except BrokenPipeError:
        sys.exit(0)
    except OSError as error:
        print(f"{name}: {error.strerror}: {error.filename}", file=sys.stderr)
        sys.exit(2)


def require_directory(directory):
    if not os.path.isdir(directory):
        raise InputError(f"there is no folder {directory}")


# --- history.csv ---------------------------------------------------------------------------------------------


def read_history(directory, name="history.csv"):
    """
    Columns of history.csv, or of a table like it, by name; fields that are empty are NaN.

    A last row that is still being written is left out.
    """
    require_directory(directory)
    path = os.path.join(directory, name)
    if not os.path.exists(path):
        raise InputError(f"{directory} has no {name}")
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    if not rows:
        raise InputError(f"{path} is empty")
    names = [name.strip() for name in rows[0]]
    values = []
    for line, row in enumerate(rows[1:], start=2):
        if len(row) != len(names):
            if line == len(rows):
                break
            raise InputError(f"{path} line {line} has {len(row)} fields where the first line names {len(names)}")
        try:
            values.append([float(item) if item.strip() else np.nan for item in row])
        except ValueError as error:
            raise InputError(f"{path} line {line}: {error}") from error
    table = np.array(values, dtype=float).reshape(-1, len(names))
    return {name: table[:, column] for column, name in enumerate(names)}


# --- parameters.prm ------------------------------------------------------------------------------------------


def read_parameters(directory):
    """Entries of parameters.prm as {(section, …, name): value}; empty when there is no such file."""
    path = os.path.join(directory, "parameters.prm")
    entries, sections = {}, []
    if not os.path.exists(path):
        return entries
    with open(path, encoding="utf-8") as file:
        for line in file:
            line = line.split("#")[0].strip()
            if match := re.match(r"subsection\s+(.*)", line):
                sections.append(match.group(1).strip())
            elif line == "end" and sections:
                sections.pop()
            elif match := re.match(r"set\s+([^=]+?)\s*=\s*(.*)", line):
                entries[(*sections, match.group(1))] = match.group(2).strip()
    return entries


def plain(name):
    """'Neo-Hookean' and 'neo_hookean' are one law."""
    return re.sub(r"[^a-z0-9]", "", name.lower())


def find_number(parameters, name, group):
    """The number called @name in the first subsection of @group that has it, in that of its law if it says one."""
    found = [(key, value) for key, value in parameters.items()
             if key[0] == group and plain(key[-1]) == plain(name)]
    for key, value in found:
        law = parameters.get((group, key[1], "Law"))
        if law is None or len(key) < 4 or plain(law) == plain(key[2]):
            try:
                return float(value)
            except ValueError:
                return None
    return None


# --- fields.pvd ----------------------------------------------------------------------------------------------


@dataclass
class Grid:
    """One VTU file: points, cells as lists of point numbers, data by name."""
    points: np.ndarray = field(default_factory=lambda: np.zeros((0, 2)))
    cells: list = field(default_factory=list)
    point_data: dict = field(default_factory=dict)
    cell_data: dict = field(default_factory=dict)


@dataclass
class FrameFiles:
    """An entry of fields.pvd."""
    number: int
    time: float
    files: dict


def read_series(directory):
    """Frames of fields.pvd in order."""
    require_directory(directory)
    path = os.path.join(directory, "fields.pvd")
    if not os.path.exists(path):
        raise InputError(f"{directory} has no fields.pvd: the run has not written pictures (see its section Output)")
    try:
        frames = []
        for item in ElementTree.parse(path).iter("DataSet"):
            time = float(item.attrib["timestep"])
            if not frames or frames[-1].time != time:
                frames.append(FrameFiles(len(frames), time, {}))
            file = item.attrib["file"]
            name = item.attrib.get("name") or os.path.basename(file).split("-")[0]
            frames[-1].files[name] = os.path.join(directory, file)
    except (ElementTree.ParseError, KeyError, ValueError) as error:
        raise InputError(f"{path} is damaged: {error}") from error
    if not frames:
        raise InputError(f"{path} has no frames yet")
    return frames


def read_grid(path):
    """One VTU file by VTK's own reader."""
    try:
        from vtkmodules.util.numpy_support import vtk_to_numpy
        from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader
    except ImportError as error:
        raise need("python3-vtk9", error) from error
    if not os.path.exists(path):
        raise InputError(f"{path}, named by fields.pvd, is missing")
    problems = []
    reader = vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: problems.append(path))
    reader.SetFileName(path)
    reader.Update()
    data = reader.GetOutput()
    if problems or data is None:
        raise InputError(f"{path} is damaged")
    grid = Grid()
    if data.GetNumberOfPoints():
        grid.points = vtk_to_numpy(data.GetPoints().GetData())[:, :2].astype(float)
    if data.GetNumberOfCells():
        offsets = vtk_to_numpy(data.GetCells().GetOffsetsArray())
        connectivity = vtk_to_numpy(data.GetCells().GetConnectivityArray())
        grid.cells = np.split(connectivity, offsets[1:-1])
    for source, target in ((data.GetPointData(), grid.point_data), (data.GetCellData(), grid.cell_data)):
        for i in range(source.GetNumberOfArrays()):
            target[source.GetArrayName(i)] = vtk_to_numpy(source.GetArray(i)).astype(float)
    return grid


def axial_strain(directory, time):
    """ln(h0/h) at a time, from history.csv; None when it does not say."""
    try:
        history = read_history(directory)
    except InputError:
        return None
    times, strains = history.get("time_s"), history.get("axial_strain")
    if times is None or strains is None:
        return None
    known = np.isfinite(strains)
    if not known.any():
        return None
    return float(np.interp(time, times[known], strains[known]))


# --- names and units -----------------------------------------------------------------------------------------

UNITS = {  # longest first: the end of a name says its unit
    "_J_per_m3": "J/m³", "_kg_m_per_s": "kg m/s", "_m_per_s2": "m/s²", "_kg_per_m3": "kg/m³", "_kg_per_m": "kg/m",
    "_N_per_m2": "N/m²", "_N_per_m": "N/m", "_J_per_m": "J/m", "_m_per_s": "m/s", "_per_s": "1/s", "_per_m": "1/m",
    "_bytes": "B", "_Pa": "Pa", "_kg": "kg", "_rad": "rad", "_m2": "m²", "_N": "N", "_J": "J", "_m": "m", "_s": "s",
}

SYMBOLS = {
    "von_mises": r"von Mises stress $\sigma_\mathrm{vM}$", "pressure": r"pressure $p$",
    "stress_xx": r"stress $\sigma_{xx}$", "stress_yy": r"stress $\sigma_{yy}$",
    "stress_xy": r"stress $\sigma_{xy}$", "stress_zz": r"stress $\sigma_{zz}$",
    "velocity": r"velocity $|v|$", "axial_strain": r"axial strain $\varepsilon = \ln(h_0/h)$",
    "packing_fraction": r"packing fraction $\Phi$", "coordination": r"coordination number $Z$", "time": r"time $t$",
    "kinetic_energy": r"kinetic energy $E_\mathrm{k}$", "elastic_energy": r"elastic energy $E_\mathrm{e}$",
    "dissipated_energy": r"dissipated energy $E_\mathrm{d}$", "width": r"width $L$",
    "dt": r"time step $\Delta t$", "max_penetration": r"largest penetration $-g$",
}

PREFIXES = {"Pa": ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")), "N/m": ((1e6, "MN/m"), (1e3, "kN/m")),
            "m": ((1, "m"), (1e-3, "mm"), (1e-6, "µm")), "s": ((1, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")),
            "J/m": ((1e3, "kJ/m"), (1, "J/m"), (1e-3, "mJ/m"), (1e-6, "µJ/m"), (1e-9, "nJ/m")),
            "m/s": ((1, "m/s"), (1e-3, "mm/s"), (1e-6, "µm/s")),
            "J/m³": ((1e9, "GJ/m³"), (1e6, "MJ/m³"), (1e3, "kJ/m³")), "m²": ((1, "m²"), (1e-6, "mm²"))}


def split_unit(name):
    """('von_mises_Pa') → ('von_mises', 'Pa'); the unit is '' for a pure number."""
    for suffix, unit in UNITS.items():
        if name.endswith(suffix) and len(name) > len(suffix):
            return name[:-len(suffix)], unit
    return name, ""


def scaled_unit(unit, largest):
    """A prefix that leaves numbers of a few digits: (divisor, unit)."""
    for scale, text in PREFIXES.get(unit, ()):
        if largest >= 0.999 * scale:
            return scale, text
    choices = PREFIXES.get(unit, ())
    if choices and choices[-1][0] < 1 and largest > 0:
        return choices[-1]
    return 1, unit


def describe(name):
    """Words and symbol for a column or field, first letter large."""
    base, _ = split_unit(name)
    match = re.match(r"(bottom|top|left|right)_(force|position)$", base)
    if base in SYMBOLS:
        text = SYMBOLS[base]
    elif match:
        text = f"{match.group(1)} wall {match.group(2)} ${'F' if match.group(2) == 'force' else 'y'}$"
    else:
        text = base.replace("_", " ")
    return text[0].upper() + text[1:] if not text.startswith("von") else text


def with_unit(text, unit):
    return f"{text}  [{unit}]" if unit else text
