# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study has found, as lines for a terminal."""

import numpy as np

from .report_entry import in_words
from .study_picture import COST_TEXTS, standard_errors


def percent(value):
    """
    A relative number in percent, empty without one.

    >>> percent(0.0123), percent(float("nan"))
    ('1.2 %', '')
    """
    return f"{100 * value:.2g} %" if np.isfinite(value) else ""


def cost_in_words(name, value):
    """A cost with its unit, empty without one."""
    if not np.isfinite(value):
        return ""
    return f"{value / 2**20:,.0f} MiB" if name == "peak_memory_bytes" else in_words(value)


def told_error(result, quantity):
    """An error, with the standard error where it is one of a mean: what is smaller than that cannot be told from 0."""
    own = percent(result.differences[quantity.name].error)
    bars = standard_errors([result], quantity)
    return f"{own} ± {percent(bars[0])}" if bars else own


def table(rows):
    """Lines of columns that are as wide as their widest cell."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return ["  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows]


def print_findings(findings):
    """Errors and costs of the points, orders, and the cheapest point for every level of the error."""
    study = findings.study
    names = [quantity.name for quantity in study.quantities]
    rows = [["point", *names, COST_TEXTS[study.cost][0], "status"]]
    for one in findings.results:
        errors = []
        for name in names:
            found = one.differences[name]
            own = "reference" if one.point.is_reference and not np.isfinite(found.error) and not found.note else \
                percent(found.error)
            if np.isfinite(found.scatter):
                own += f" (one run ± {percent(found.scatter)})"
            errors.append(own + ("  *" if one.front[name] else ""))
        rows.append([one.point.label, *errors, cost_in_words(study.cost, one.cost(study.cost)),
                     "; ".join([one.status, *one.notes])])
    print("\n" + "\n".join(table(rows)) + "\n* no other point is both cheaper and nearer to the reference")
    for order in findings.orders:
        others = ", ".join(f"{name} = {value}" for name, value in order.others.items())
        if order.good:
            print(f"{order.quantity} over {order.knob}{' at ' + others if others else ''}: order {order.order:.2f} "
                  f"(R² {order.quality:.3f})")
    for quantity in study.quantities:
        for level in study.levels:
            one = findings.cheapest(quantity.name, level)
            print(f"{quantity.name} within {percent(level)}: " +
                  (f"{one.point.label}, {told_error(one, quantity)}, {cost_in_words(study.cost, one.cost(study.cost))}"
                   if one else "no point"))
