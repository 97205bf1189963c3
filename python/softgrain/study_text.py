# SPDX-License-Identifier: LGPL-2.1-or-later
"""What a study has found, as lines for a terminal."""

import numpy as np

from .report_entry import in_words
from .study_picture import COST_TEXTS
from .study_verdict import MOST, by_place, deciding_place


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
    """An error with what it may be off by: a smaller one cannot be told from 0."""
    own, off = percent(result.differences[quantity.name].error), result.uncertainty[quantity.name]
    return (
        own
        if off == 0
        else f"{own} ± {percent(off)}" if np.isfinite(off) else f"{own} at one place"
    )


def in_doubt(findings, quantity):
    """Who cannot decide, as words."""
    return (
        "one packing cannot decide"
        if findings.has_one_packing(quantity)
        else "the runs cannot decide"
    )


def what_would_decide(findings, quantity, found):
    """Where the doubt of a Verdict comes from, and how many packings would end it, as words."""
    words = []
    if findings.has_one_packing(quantity):
        named = {
            deciding_place(quantity, one.differences[quantity.name].signed)
            for one in findings.results
            if one.of_one_packing[quantity.name]
            and one.differences[quantity.name].signed is not None
        } - {""}
        if len(named) == 1:
            words.append(f"most of that is made at {quantity.x.text} = {named.pop()} alone")
    what = "packings" if findings.has_one_packing(quantity) else "runs of each point"
    words.append(
        f"about {found.needed:.0f} {what} would decide"
        if np.isfinite(found.needed)
        else f"so near to the level, more than {MOST} {what} would be needed"
    )
    return "; ".join(words)


def told_verdict(findings, quantity, level):
    """
    The cheapest point within a level of the error, or that it is not known which, and what would
    tell.
    """
    found = findings.verdict(quantity, level)
    own = (
        f"{found.result.point.label}, {told_error(found.result, quantity)}, "
        f"{cost_in_words(findings.study.cost, found.result.cost(findings.study.cost))}"
        if found.result
        else "no point"
    )
    safe = f"; surely within: {found.safe.point.label}" if found.safe else ""
    return (
        own
        if found.sure
        else (
            f"{in_doubt(findings, quantity)} (it would say: {own}){safe};"
            f" {what_would_decide(findings, quantity, found)}"
        )
    )


def told_place(error, off):
    """An error at a place, with what it may be off by where that is known."""
    return percent(error) + (f" ± {percent(off)}" if np.isfinite(off) else "")


def place_rows(findings, quantity):
    """
    The errors of packings place by place, as rows of cells with a head; nothing where there is one
    place, or nothing is random.
    """
    rows = [
        (one.point.label, by_place(quantity, one.differences[quantity.name]))
        for one in findings.results
        if one.differences[quantity.name].signed is not None
        and (one.of_one_packing[quantity.name] or one.uncertainty[quantity.name] > 0)
    ]
    rows = [(label, found) for label, found in rows if len(found) > 1]
    return (
        [
            [f"{quantity.name} at {quantity.x.text} =", *rows[0][1]],
            *([label, *(told_place(*one) for one in found.values())] for label, found in rows),
        ]
        if rows
        else []
    )


def about_places(findings, quantity):
    """What is to be said above the errors place by place."""
    if findings.has_one_packing(quantity):
        return (
            "errors of one packing, place by place: another packing may have others; give"
            f" {quantity.name} several packings (a knob with 'Average = true')"
        )
    return "errors place by place, with the standard error over the runs of a point"


def table(rows):
    """Lines of columns that are as wide as their widest cell."""
    widths = [max(map(len, column)) for column in zip(*rows)]
    return [
        "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip() for row in rows
    ]


def print_findings(findings):
    """
    Errors and costs of the points, orders, and the cheapest point for every level of the error.
    """
    study = findings.study
    names = [quantity.name for quantity in study.quantities]
    stars = {
        quantity.name: "*" if findings.is_front_sure(quantity) else "(*)"
        for quantity in study.quantities
    }
    rows = [["point", *names, COST_TEXTS[study.cost][0], "status"]]
    for one in findings.results:
        errors = []
        for name in names:
            found = one.differences[name]
            own = (
                "reference"
                if one.point.is_reference and not np.isfinite(found.error) and not found.note
                else percent(found.error)
            )
            if np.isfinite(found.scatter):
                own += f" (one run ± {percent(found.scatter)})"
            elif one.of_one_packing[name] and np.isfinite(one.uncertainty[name]):
                own += f" ± {percent(one.uncertainty[name])}"
            errors.append(own + (f"  {stars[name]}" if one.front[name] else ""))
        rows.append(
            [
                one.point.label,
                *errors,
                cost_in_words(study.cost, one.cost(study.cost)),
                "; ".join([one.status, *one.notes]),
            ]
        )
    print(
        "\n"
        + "\n".join(table(rows))
        + "\n* no other point is both cheaper and nearer to the reference"
        + ("; (*) perhaps: what errors may be off by decides it" if "(*)" in stars.values() else "")
    )
    for quantity in study.quantities:
        if rows := place_rows(findings, quantity):
            print(about_places(findings, quantity) + "\n" + "\n".join(table(rows)))
    for order in findings.orders:
        others = ", ".join(f"{name} = {value}" for name, value in order.others.items())
        if order.good:
            print(
                f"{order.quantity} over {order.knob}{' at ' + others if others else ''}: order"
                f" {order.order:.2f} (R² {order.quality:.3f})"
            )
    for quantity in study.quantities:
        for level in study.levels:
            print(
                f"{quantity.name} within {percent(level)}:"
                f" {told_verdict(findings, quantity, level)}"
            )
