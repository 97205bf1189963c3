#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""One grain pressed until it fills its box: pressure by resolution, and the constants that packings are compared with.

Runs verification/four_plates.prm and verification/confined_disk.prm and prints the mean pressure of the plates, at packing
fractions and at ways of the plates, over that of the finest grid. From the four plates b and Φmax of
P/E = -b ln((Φmax - Φ)/(Φmax - Φ0)) [Cantor et al. 2020] with Φ0 = π/4, where the disk touches the box, by least squares of P;
and Γ of P/E = Z Φ ln(Φ/Φ0)/(2 Γ) with Z = 4."""
import math

from running import RunFailed, parser_of, read_run, run

YOUNG, DIAMETER = 10e6, 1e-2  # of the scenes [Pa, m]
PHI_0 = math.pi / 4
SCENES = ("four_plates", "confined_disk")
PLATES = ("bottom", "top", "left", "right")
FRACTIONS = (0.82, 0.86, 0.90, 0.95, 0.98)
WAYS = (0.02, 0.05, 0.10, 0.14)  # of a plate over the radius; twice in confined_disk, where two plates move
GAMMAS = (0.80, 0.82, 0.84, 0.86)  # packing fractions
END = 0.985
STEP = 1.25e-3  # way of a plate over the radius


def curve(program, folder, scene, spacing, poisson=0.45):
    """[(way of the plates, Φ, P/E)] of a run; says how it went."""
    changes = {"Mesh/Cell size": spacing * DIAMETER, "Stop/Packing fraction": END, "Output/Number of field outputs": 0,
               "Time/Time step": STEP, "Materials/gel/Neo-Hookean/Poisson's ratio": poisson}
    remark = ""
    try:
        _, rows = run(program, f"verification/{scene}.prm", folder, changes, threads=1, again=False)
    except RunFailed as failure:
        _, rows = read_run(folder)
        remark = f", ended early: {str(failure).strip().splitlines()[-1]}"
    points = []
    for row in rows:
        width = row["right_position_m"] - row["left_position_m"]
        height = row["top_position_m"] - row["bottom_position_m"]
        force = {plate: row[f"{plate}_force_N_per_m"] for plate in PLATES}
        pressure = 0.25 * ((force["top"] + force["bottom"]) / width + (force["left"] + force["right"]) / height)
        points.append((row["time_s"], row["packing_fraction"], pressure / YOUNG))
    print(f"{scene}, ξ = {spacing}, ν = {poisson}: {len(rows) - 1} steps to Φ = {points[-1][1]:.4f}{remark}", flush=True)
    return points


def at(points, place):
    """P/E between steps, ln P as a line; @points (place, P/E), nan where the run did not come."""
    for (low, below), (high, above) in zip(points, points[1:]):
        if low <= place <= high and below > 0:
            share = (place - low) / (high - low)
            return math.exp((1 - share) * math.log(below) + share * math.log(above))
    return math.nan


def comparison(curves, spacings, column, places, what):
    """A table of P/E at values of a column, with the difference from the first spacing."""
    print("\n| scene | ξ | " + " | ".join(f"{what} {place}" for place in places) + " |\n|" + "---|" * (2 + len(places)))
    for scene in SCENES:
        for spacing in spacings:
            cells = []
            for place in places:
                place *= 2 if scene == "confined_disk" and column == 0 else 1
                value, right = (at([(point[column], point[2]) for point in curves[scene, one]], place)
                                for one in (spacing, spacings[0]))
                cells.append(f"{value:.4f}" + ("" if spacing == spacings[0] else f" ({100 * (value / right - 1):+.1f} %)"))
            print(f"| {scene} | {spacing} | " + " | ".join(cells) + " |")


def fitted(points, high, tops):
    """b, Φmax (one of @tops) and the r.m.s. error over the largest P, for Φ up to @high."""
    used = [(phi, p) for _, phi, p in points if PHI_0 < phi <= high and p > 0]
    best = None
    for top in tops:
        if top <= used[-1][0]:
            continue
        shape = [-math.log((top - phi) / (top - PHI_0)) for phi, _ in used]
        b = sum(s * p for s, (_, p) in zip(shape, used)) / sum(s * s for s in shape)
        error = math.sqrt(sum((b * s - p) ** 2 for s, (_, p) in zip(shape, used)) / len(used)) / used[-1][1]
        if best is None or error < best[2]:
            best = b, top, error
    return best


def constants(name, points):
    """A line of the table of constants."""
    cells = []
    for high in (0.95, 0.98):
        for tops in ([0.95 + 1e-4 * i for i in range(1000)], [1.0]):
            b, top, error = fitted(points, high, tops)
            cells.append(f"{b:.3f}" + (f", {top:.3f}" if len(tops) > 1 else "") + f" ({100 * error:.1f} %)")
    pressure = [(phi, p) for _, phi, p in points]
    cells += [f"{2 * phi * math.log(phi / PHI_0) / at(pressure, phi):.2f}" for phi in GAMMAS]
    print(f"| {name} | " + " | ".join(cells) + " |")


def main():
    parser = parser_of(__doc__, "single_grain")
    parser.add_argument("--spacings", type=float, nargs="+", default=[0.0145, 0.029, 0.058, 0.10, 0.17],
                        help="cells over diameters, the reference first (default: %(default)s)")
    parser.add_argument("--poisson", type=float, nargs="*", default=[0.3, 0.495],
                        help="other Poisson's ratios for the constants, at ξ = 0.029 (default: %(default)s)")
    arguments = parser.parse_args()
    curves = {(scene, spacing): curve(arguments.program, arguments.folder / f"{scene}-{spacing}", scene, spacing)
              for spacing in reversed(arguments.spacings) for scene in SCENES}
    others = {poisson: curve(arguments.program, arguments.folder / f"four_plates-poisson-{poisson}", "four_plates", 0.029, poisson)
              for poisson in arguments.poisson}
    comparison(curves, arguments.spacings, 1, FRACTIONS, "Φ =")
    comparison(curves, arguments.spacings, 0, WAYS, "way / R =")
    print("\n| grain | b, Φmax up to 0.95 | b with Φmax = 1 | b, Φmax up to 0.98 | b with Φmax = 1 | "
          + " | ".join(f"Γ at {phi}" for phi in GAMMAS) + " |\n|" + "---|" * (5 + len(GAMMAS)))
    for spacing in arguments.spacings:
        constants(f"ν = 0.45, ξ = {spacing}", curves["four_plates", spacing])
    for poisson in arguments.poisson:
        constants(f"ν = {poisson}, ξ = 0.029", others[poisson])


if __name__ == "__main__":
    main()
