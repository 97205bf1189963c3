# SPDX-License-Identifier: LGPL-2.1-or-later
"""study.csv and study.json: what a study has found, for other programs."""

import csv
import json
import os

import numpy as np

from .page import plain
from .study_points import folder_of
from .study_verdict import by_place


def rows_of(findings):
    """The rows of study.csv, {column: value}."""
    study = findings.study
    for one in findings.results:
        row = {
            "point": one.point.label,
            "reference": int(one.point.is_reference),
            **one.point.values,
        }
        for name, found in one.differences.items():
            row[f"error_{name}"], row[f"scatter_{name}"] = found.error, found.scatter
            row[f"front_{name}"] = int(one.front[name])
        for name in ("cpu_seconds", "wall_seconds", "peak_memory_bytes"):
            row[name] = one.cost(name)
        row |= {
            "steps": one.steps,
            "newton_iterations_per_step": one.per_step("newton_iterations"),
            "contact_sweeps_per_step": one.per_step("contact_sweeps"),
            "runs": sum(run is not None for run in one.runs),
            "status": one.status,
            "notes": "; ".join(one.notes),
        }
        if not any(knob.average for knob in study.knobs):
            row = {name: value for name, value in row.items() if not name.startswith("scatter_")}
        yield row


def text_of_cell(value):
    if isinstance(value, float):
        return "" if not np.isfinite(value) else f"{value:.6g}"
    return str(value)


def write_csv(findings, path):
    rows = list(rows_of(findings))
    with open(path + ".part", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(rows[0])
        writer.writerows([text_of_cell(value) for value in row.values()] for row in rows)
    os.replace(path + ".part", path)


def write_json(findings, path, output):
    """All numbers, the parameters of every run too."""
    study = findings.study
    points = []
    for row, one in zip(rows_of(findings), findings.results):
        row["signed_differences"] = {
            name: found.signed
            for name, found in one.differences.items()
            if found.signed is not None and len(found.signed) <= 50
        }
        row["uncertainties"] = one.uncertainty
        row["place_by_place"] = {
            quantity.name: {
                place: {"error": error, "standard_error": off}
                for place, (error, off) in by_place(
                    quantity, one.differences[quantity.name]
                ).items()
            }
            for quantity in study.quantities
            if one.differences[quantity.name].signed is not None
        }
        row["tasks"] = [
            {
                "values": task.values,
                "changes": task.changes,
                "folder": os.path.relpath(folder_of(output, task), output),
                **{name: value for name, value in record.items() if name != "changes"},
            }
            for task, record in zip(one.point.tasks, one.records)
        ]
        points.append(row)
    found = {
        quantity.name: {f"{level:g}": findings.verdict(quantity, level) for level in study.levels}
        for quantity in study.quantities
    }
    # What cannot be decided is no answer: it stands under a name of its own.
    cheapest = {
        name: {
            level: one.result.point.label if one.result and one.sure else None
            for level, one in of.items()
        }
        for name, of in found.items()
    }
    perhaps = {
        name: {
            level: one.result and one.result.point.label
            for level, one in of.items()
            if not one.sure
        }
        for name, of in found.items()
    }
    data = {
        "title": study.title,
        "scene": study.scene,
        "study": study.path,
        "reference": study.reference,
        "cost": study.cost,
        "points": points,
        "orders": [{**vars(order), "good": order.good} for order in findings.orders],
        "cheapest": cheapest,
        "perhaps_cheapest": perhaps,
        "packings_needed": {
            name: {level: one.needed for level, one in of.items() if not one.sure}
            for name, of in found.items()
        },
        "cheapest_is_sure": {
            name: {level: bool(one.result and one.sure) for level, one in of.items()}
            for name, of in found.items()
        },
        "none_is_sure": {
            name: {level: one.result is None and one.sure for level, one in of.items()}
            for name, of in found.items()
        },
        "surely_within": {
            name: {level: one.safe and one.safe.point.label for level, one in of.items()}
            for name, of in found.items()
        },
        "front_is_sure": {
            quantity.name: findings.is_front_sure(quantity) for quantity in study.quantities
        },
    }
    with open(path + ".part", "w", encoding="utf-8") as file:
        json.dump(plain(data), file, indent=1, ensure_ascii=False, allow_nan=False)
    os.replace(path + ".part", path)
