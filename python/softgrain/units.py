# SPDX-License-Identifier: LGPL-2.1-or-later
"""Names and units: the end of every name in softgrain's files says its unit."""

import re

UNITS = {  # longest first: the end of a name says its unit
    "_kg_m_per_s": "kg m/s",
    "_kg_per_m3": "kg/m³",
    "_rad_per_s": "rad/s",
    "_J_per_m3": "J/m³",
    "_N_per_m2": "N/m²",
    "_m_per_s2": "m/s²",
    "_kg_per_m": "kg/m",
    "_per_rad": "1/rad",
    "_per_Pa": "1/Pa",
    "_N_per_m": "N/m",
    "_J_per_m": "J/m",
    "_m_per_s": "m/s",
    "_per_s": "1/s",
    "_per_m": "1/m",
    "_bytes": "B",
    "_N_m": "N m",
    "_Pa": "Pa",
    "_kg": "kg",
    "_rad": "rad",
    "_m3": "m³",
    "_m2": "m²",
    "_N": "N",
    "_J": "J",
    "_m": "m",
    "_s": "s",
}

SYMBOLS = {
    "von_mises": r"von Mises stress $\sigma_\mathrm{vM}$",
    "pressure": r"pressure $p$",
    "stress_xx": r"stress $\sigma_{xx}$",
    "stress_yy": r"stress $\sigma_{yy}$",
    "stress_xy": r"stress $\sigma_{xy}$",
    "stress_zz": r"stress $\sigma_{zz}$",
    "velocity": r"velocity $|v|$",
    "axial_strain": r"axial strain $\varepsilon = \ln(h_0/h)$",
    "packing_fraction": r"packing fraction $\Phi$",
    "coordination": r"coordination number $Z$",
    "time": r"time $t$",
    "coordination_of_bodies": r"coordination number $Z$ of bodies alone",
    "kinetic_energy": r"kinetic energy $E_\mathrm{k}$",
    "elastic_energy": r"elastic energy $E_\mathrm{e}$",
    "dissipated_energy": r"dissipated energy $E_\mathrm{d}$",
    "width": r"width $L$",
    "dt": r"time step $\Delta t$",
    "max_penetration": r"largest penetration $-g$",
    "equivalent_strain": r"equivalent strain $\varepsilon_\mathrm{eq}$",
    "shear_strain": r"largest shear strain $\frac{1}{2}(\ln\lambda_1 - \ln\lambda_2)$",
    "contact_pressure": r"contact pressure $p(s)$",
    "contact_traction": r"contact traction $q(s)$",
    "volume_strain": r"volume strain $\ln J$",
    "mean_pressure": r"mean pressure $p$",
}

PREFIXES = {
    "Pa": ((1e9, "GPa"), (1e6, "MPa"), (1e3, "kPa")),
    "N/m": ((1e6, "MN/m"), (1e3, "kN/m")),
    "m": ((1, "m"), (1e-3, "mm"), (1e-6, "µm")),
    "s": ((1, "s"), (1e-3, "ms"), (1e-6, "µs"), (1e-9, "ns")),
    "J/m": ((1e3, "kJ/m"), (1, "J/m"), (1e-3, "mJ/m"), (1e-6, "µJ/m"), (1e-9, "nJ/m")),
    "m/s": ((1, "m/s"), (1e-3, "mm/s"), (1e-6, "µm/s")),
    "J/m³": ((1e9, "GJ/m³"), (1e6, "MJ/m³"), (1e3, "kJ/m³")),
    "m²": ((1, "m²"), (1e-6, "mm²")),
    "m³": ((1, "m³"), (1e-9, "mm³")),
    "N": ((1e6, "MN"), (1e3, "kN"), (1, "N"), (1e-3, "mN"), (1e-6, "µN")),
    "J": ((1e3, "kJ"), (1, "J"), (1e-3, "mJ"), (1e-6, "µJ"), (1e-9, "nJ")),
}


def split_unit(name):
    """
    The name without its unit, and the unit, '' for a pure number.

    >>> split_unit("von_mises_Pa"), split_unit("packing_fraction")
    (('von_mises', 'Pa'), ('packing_fraction', ''))
    """
    for suffix, unit in UNITS.items():
        if name.endswith(suffix) and len(name) > len(suffix):
            return name[: -len(suffix)], unit
    return name, ""


def full_name(name, columns):
    """
    The name among @p columns that is meant, its unit left out or not; None where it is not clear.

    >>> full_name("force", ["force_N"]), full_name("force", ["force_N", "force_N_per_m"])
    ('force_N', None)
    """
    if name in columns:
        return name
    full = [name + suffix for suffix in UNITS if name + suffix in columns]
    return full[0] if len(full) == 1 else None


def scaled_unit(unit, largest):
    """
    A prefix that leaves numbers of a few digits: (divisor, unit).

    >>> scaled_unit("Pa", 2.5e6)
    (1000000.0, 'MPa')
    """
    for scale, text in PREFIXES.get(unit, ()):
        if largest >= 0.999 * scale:
            return scale, text
    choices = PREFIXES.get(unit, ())
    if choices and choices[-1][0] < 1 and largest > 0:
        return choices[-1]
    return 1, unit


def describe(name):
    """
    Words and symbol for a column or field, first letter large.

    >>> describe("lower_from_upper_force_y_N_per_m"), describe("lower_contact_torque_N")
    ('Force y on lower from upper', 'Torque on lower')
    """
    base, _ = split_unit(name)
    match = re.match(r"(bottom|top|left|right)_(force|position)$", base)
    if base in SYMBOLS:
        text = SYMBOLS[base]
    elif load := re.match(r"(.+?)_(?:from_(.+)|contact)_(force_[xy]|torque)$", base):
        text = f"{load.group(3).replace('_', ' ')} on {load.group(1)}" + (
            f" from {load.group(2)}" if load.group(2) else ""
        )
    elif match:
        text = (
            f"{match.group(1)} wall {match.group(2)} ${'F' if match.group(2) == 'force' else 'y'}$"
        )
    else:
        text = base.replace("_", " ")
    return text[:1].upper() + text[1:] if not text.startswith("von") else text


def with_unit(text, unit):
    """A text with its unit in brackets, as for an axis."""
    return f"{text}  [{unit}]" if unit else text


SIGNS = {
    "sigma": "σ",
    "varepsilon": "ε",
    "Phi": "Φ",
    "Delta": "Δ",
    "lambda": "λ",
    "ln": "ln",
    "frac{1}{2}": "½",
}


def html_of(text):
    r"""
    A text with formulas, as describe() gives it, in HTML.

    >>> html_of(describe("stress_xx_Pa")), html_of(r"$E_\mathrm{k}$")
    ('Stress σ<sub>xx</sub>', 'E<sub>k</sub>')
    """

    def formula(match):
        inside = re.sub(r"\\mathrm\{([^}]*)\}", r"{\1}", match.group(1))
        for name, sign in SIGNS.items():
            inside = inside.replace("\\" + name, sign)
        return re.sub(
            r"_(?:\{([^}]*)\}|(\w))",
            lambda part: f"<sub>{part.group(1) or part.group(2)}</sub>",
            inside,
        )

    return re.sub(r"\$([^$]*)\$", formula, text)
