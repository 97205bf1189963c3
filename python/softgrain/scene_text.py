# SPDX-License-Identifier: LGPL-2.1-or-later
"""A scene as the text of a parameter file, as one would write it by hand."""

import math
from collections.abc import Mapping
from decimal import Decimal
from typing import Dict, Optional

from .errors import InputError
from .listing import Entry


def separator_of(entry: Optional[Entry]) -> str:
    """
    What stands between the items of a list: vectors of formulas and lists of points have
    semicolons.
    """
    return (
        "; "
        if entry is not None and ("separated by ';'" in entry.allowed or ";" in entry.default)
        else ", "
    )


def number_text(value: float) -> str:
    """
    A number as one would write it, with the 15 digits that are sure.

    >>> [number_text(one) for one in (1e6, 450000., 0.0005, 0.02, 3., 1 / 3, 123456., 3 * 0.1)]
    ['1e6', '4.5e5', '5e-4', '0.02', '3', '0.333333333333333', '123456', '0.3']
    """
    value = float(f"{value:.15g}")
    plain = repr(value).removesuffix(".0")
    if not math.isfinite(value) or value == 0:
        return plain
    sign, digits, exponent = Decimal(repr(value)).normalize().as_tuple()
    power = int(exponent) + len(digits) - 1
    short = (
        "-" * sign
        + str(digits[0])
        + ("." + "".join(map(str, digits[1:])) if len(digits) > 1 else "")
        + f"e{power}"
    )
    return (
        short if (power <= -3 or power >= 5) and len(short) < len(plain) or "e" in plain else plain
    )


def value_text(value, entry: Optional[Entry] = None) -> str:
    """
    A value as a parameter file has it.

    >>> points = Entry("Points", "", "a list separated by ';', each of them ...", "")
    >>> (value_text([(0, 1), (2, 3)], points), value_text((0, 1e-3)), value_text(True),
    ...  value_text({("gel", "stone"): 0.3}))
    ('0, 1; 2, 3', '0, 1e-3', 'true', 'gel / stone: 0.3')
    """
    if hasattr(value, "_name"):  # a material, by its name
        return value._name
    if hasattr(value, "tolist"):  # of numpy
        value = value.tolist()
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):  # of pairs
        return "; ".join(
            f"{' / '.join(value_text(one) for one in pair)}: {value_text(number)}"
            for pair, number in value.items()
        )
    if isinstance(value, (list, tuple, range)):
        return separator_of(entry).join(value_text(one) for one in value)
    text = number_text(value) if isinstance(value, float) else str(value)
    if "\n" in text or "#" in text:
        raise InputError(f"a value has no '#' and no new line: {text!r}")
    return text


def scene_text(entries: Dict[str, str], title: str = "") -> str:
    """
    {"Section/Name": text} as a parameter file, in the order given; sections of the first level
    stand apart.
    """
    tree: dict = {}
    for path, text in entries.items():
        *sections, name = path.split("/")
        place = tree
        for section in sections:
            place = place.setdefault((section,), {})
        place[name] = text
    lines = [f"# {line}".rstrip() for line in title.splitlines()]
    own = list(lines_of(tree))
    return "\n".join([*lines, *([""] if lines and own and own[0] else []), *own]).strip("\n") + "\n"


def lines_of(tree: dict, level: int = 0):
    """Lines of a section: its parameters, aligned, then its subsections."""
    indent, own = "  " * level, {name: text for name, text in tree.items() if isinstance(name, str)}
    width = max(map(len, own), default=0)
    for name, text in own.items():
        yield f"{indent}set {name.ljust(width)} = {text}".rstrip()
    for name, below in tree.items():
        if not isinstance(name, str):
            yield from [""] if level == 0 else []
            yield f"{indent}subsection {name[0]}"
            yield from lines_of(below, level + 1)
            yield f"{indent}end"


def grains_text(grains) -> str:
    """Disks (x, y, radius, material) as a table that 'Packing/File' can name."""
    with_material = any(material for *_, material in grains)
    lines = ["x_m,y_m,radius_m" + (",material" if with_material else "")]
    lines += [
        ",".join(map(repr, numbers)) + (f",{material}" if with_material else "")
        for *numbers, material in grains
    ]
    return "\n".join(lines) + "\n"
