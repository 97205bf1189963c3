#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Grains of a plastic continuum against bonded grains, for doc/results/plastic-against-bonded.md: which E and S_y one bonded grain
has, fitted to its plateau and to its unloading, and how well thirty such grains foretell thirty bonded ones."""
import pathlib
import statistics

from running import RunFailed, box, parser_of, run, softgrain

RADIUS = 2e-3  # of the bonded grain [m]
TURN = 0.15  # strain from which it is unloaded
PRIMARIES = {"Primaries/Smallest diameter": 0.10e-3, "Primaries/Largest diameter": 0.18e-3}  # of thirty_grains_bpm
EARLY, LATE = (0.04, 0.08), (0.11, 0.15)  # of the plateau
NAMES = {30: "thirty"}  # of folders
FRACTIONS = (0.80, 0.84, 0.88, 0.92, 0.94)
WIDTH, HEIGHT = 10e-3, 11.4e-3  # of the box of thirty grains, in which every packing finds room [m]
QUIET = {"Output/Fields every": 0, "Output/Snapshots every": 0}


def bonded_grain(program, folder, seed):
    """[(strain, stress)] of a bonded grain, pressed and let go."""
    turn = TURN * 2 * RADIUS / 0.2
    changes = {**PRIMARIES, **QUIET, "Primaries/Seed": seed, "Walls/top/Velocity": f"t < {turn:g} ? 0.2 : -0.2", "Stop/Axial strain": 0,
               "Stop/End time": 1.12 * turn, "Output/History every": 1}
    _, rows = run(program, "gallery/one_grain_bpm.prm", folder / f"bonded-{seed}", changes, threads=1, again=False)
    return [((RADIUS - row["top_position_m"]) / (2 * RADIUS), (row["top_force_N_per_m"] + row["bottom_force_N_per_m"]) / (4 * RADIUS))
            for row in rows]


def plastic_grain(program, folder, young, strength, hardening, poisson, cell=5.8e-4):
    """The same of a disk of J2 plasticity."""
    law = "Materials/gel/J2 plastic/"
    velocity = f"t < {TURN} ? 5e-3 : -5e-3"
    changes = {"Materials/gel/Law": "j2_plastic", law + "Young's modulus": young, law + "Poisson's ratio": poisson,
               law + "Yield stress": strength, law + "Hardening modulus": hardening, "Walls/bottom/Velocity": velocity,
               "Walls/top/Velocity": velocity, "Time/Time step": 2.5e-3, "Stop/End time": 1.1 * TURN, "Mesh/Cell size": cell,
               "Material points/F-bar": "on", "Output/Number of field outputs": 0}
    name = f"plastic-{young:.4g}-{strength:.4g}-{hardening:.4g}-{poisson}-{cell:g}"
    _, rows = run(program, "verification/line_contact.prm", folder / name, changes, threads=1, again=False)
    return [(row["time_s"] if row["time_s"] < TURN + 1e-9 else 2 * TURN - row["time_s"], row["top_force_N_per_m"] / 10e-3) for row in rows]


def mean(curve, low, high):
    """Of the stress between two strains on the way there."""
    turn = max(range(len(curve)), key=lambda i: curve[i][0])
    return statistics.fmean(stress for strain, stress in curve[:turn + 1] if low <= strain <= high)


def unloading(curve):
    """Slope between 0.9 and 0.3 of the stress of @curve's late plateau, on the way back."""
    turn = max(range(len(curve)), key=lambda i: curve[i][0])
    level, found = mean(curve, *LATE), []
    for share in (0.9, 0.3):
        before = curve[turn]
        for point in curve[turn:]:
            if point[1] < share * level:
                part = (before[1] - share * level) / (before[1] - point[1]) if before[1] > point[1] else 0
                found.append((before[0] + part * (point[0] - before[0]), share * level))
                break
            before = point
    return (found[0][1] - found[1][1]) / (found[0][0] - found[1][0]) if len(found) == 2 else float("nan")


def middle(curves):
    """Mean of the stress of @curves at strains, there and back: a single bonded grain yields and lets go in events."""
    result = []
    for back in (False, True):
        strains = [TURN - 1e-4 * i for i in range(120)] if back else [TURN / 300 * i for i in range(300)]
        half = 2e-4 if back else 2.5e-4
        parts = []
        for curve in curves:
            turn = max(range(len(curve)), key=lambda i: curve[i][0])
            parts += [curve[turn:] if back else curve[:turn]]
        for strain in strains:
            near = [[stress for at, stress in part if abs(at - strain) <= half] for part in parts]
            values = [statistics.fmean(stresses) for stresses in near if stresses]
            if values:
                result.append((strain, statistics.fmean(values)))
    return result


def figures(curve):
    return mean(curve, *EARLY), mean(curve, *LATE), unloading(curve)


def fitted(program, folder, wanted, poisson):
    """E, S_y and H whose disk has the early and late plateau and the slope of @wanted; H is 0 where it would be negative."""
    early, late, slope = wanted
    young, strength, hardening = 2 * slope, 0.8 * early, 0.0
    for _ in range(5):
        found = figures(plastic_grain(program, folder, young, strength, hardening, poisson))
        print(f"  E = {young:.4g}, S_y = {strength:.4g}, H = {hardening:.4g}: plateau {found[0]:.4g}, {found[1]:.4g}, slope {found[2]:.4g}",
              flush=True)
        strength *= (0.5 * (early + late)) / (0.5 * (found[0] + found[1])) if hardening == 0 else early / found[0]
        young *= slope / found[2]
        hardening = max(0.0, hardening + (late - early - found[1] + found[0]) / (LATE[0] - EARLY[0]) / 1.3)
    return young, strength, hardening


def assembly(program, folder, scene, name, changes, width):
    """Stress, coordination and aspect ratio at packing fractions, and the curve."""
    try:
        summary, rows = run(program, f"gallery/{scene}.prm", folder / name, changes, threads=1, again=False)
    except RunFailed as trouble:
        print(f"  {name}: {str(trouble).strip().splitlines()[-1]}")
        rows = softgrain.open(folder / name)
        rows = [dict(zip(rows.history_table, row)) for row in zip(*(rows.history_table[key].tolist() for key in rows.history_table))]
    curve = [(row["packing_fraction"], (row["top_force_N_per_m"] + row["bottom_force_N_per_m"]) / 2 / width, row["coordination"]) for row in rows]
    table = softgrain.open(folder / name).measures
    shape = list(zip(table["packing_fraction"].tolist(), table["aspect_ratio"].tolist()))

    def at(pairs, place, half):
        near = [value for fraction, value in pairs if abs(fraction - place) <= half]
        return statistics.fmean(near) if near else float("nan")
    return curve, [(at([c[:2] for c in curve], f, 0.01), at([(c[0], c[2]) for c in curve], f, 0.01), at(shape, f, 0.012)) for f in FRACTIONS]


def draw(picture, ones, thirties):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as pyplot
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.4))
    for name, curve in ones.items():
        left.plot([c[0] for c in curve], [c[1] / 1e6 for c in curve], lw=1.4 if "J2" in name or "mean" in name else 0.5, label=name)
    left.set(xlabel="axial strain", ylabel="force over diameter [MPa]", title="one grain")
    left.legend(frameon=False, fontsize=7)
    for name, curve in thirties.items():
        right.plot([c[0] for c in curve], [c[1] / 1e6 for c in curve], lw=1.4 if "J2" in name or "mean" in name else 0.5, label=name)
    right.set(xlabel="packing fraction", ylabel="stress [MPa]", title="thirty grains", xlim=(0.74, 0.96))
    right.legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(picture, dpi=110)


def main():
    parser = parser_of(__doc__, "plastic_against_bonded")
    parser.add_argument("--grains", type=int, default=6, help="bonded grains of other seeds (default: %(default)s)")
    parser.add_argument("--packings", type=int, nargs="+", default=[1, 2, 3], help="seeds of the packings (default: 1 2 3)")
    parser.add_argument("--number", type=int, default=30, help="grains of an assembly (default: 30)")
    parser.add_argument("--poisson", type=float, default=0.3)
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for the figure")
    words = parser.parse_args()
    ones = {f"bonded, {seed}": bonded_grain(words.program, words.folder, seed) for seed in range(1, words.grains + 1)}
    each = [figures(curve) for curve in ones.values()]
    ones["bonded, mean"] = middle(list(ones.values()))
    wanted = figures(ones["bonded, mean"])
    spread = [statistics.stdev(column) for column in zip(*each)]
    print(f"bonded grain, mean of {words.grains}: early plateau {wanted[0]:.4g} ± {spread[0]:.2g}, late {wanted[1]:.4g} ± {spread[1]:.2g}, "
          f"unloading slope {wanted[2]:.4g}; of each {', '.join(f'{values[2]:.2g}' for values in each)} Pa", flush=True)
    young, strength, hardening = fitted(words.program, words.folder, wanted, words.poisson)
    print(f"E = {young:.4g} Pa, S_y = {strength:.4g} Pa, H = {hardening:.4g} Pa with ν = {words.poisson}")
    ones["J2"] = plastic_grain(words.program, words.folder, young, strength, hardening, words.poisson)
    print("J2 grain: " + ", ".join(f"{value:.4g}" for value in figures(ones["J2"]))
          + "; on cells half as large: " + ", ".join(f"{value:.4g}" for value in figures(
              plastic_grain(words.program, words.folder, young, strength, hardening, words.poisson, 2.9e-4))), flush=True)
    law = "Materials/gel/J2 plastic/"
    room, width, height = box(words.number, 30, WIDTH, HEIGHT)
    plastic = {"Materials/gel/Law": "j2_plastic", law + "Young's modulus": young, law + "Poisson's ratio": words.poisson,
               law + "Yield stress": strength, law + "Hardening modulus": hardening, "Material points/F-bar": "on", **QUIET,
               "Output/Measures": "packing, coordination, shape", "Output/Snapshots every": 4e-5, "Quasi-static/Held steps": 1000, "Mesh/Upper": f"{width + 1e-3:.6g}, {height + 1e-3:.6g}", **room}
    bonded = {**PRIMARIES, **QUIET, **room, "Walls/top/Velocity": 2, "Stop/End time": 2.6e-3 * height / HEIGHT, "Output/Measures": "packing, coordination, shape",
              "Output/Snapshots every": 2e-5, "Output/History every": 1}
    kinds = {"bonded": ("thirty_grains_bpm", bonded), "J2": ("thirty_grains_quasi_static_mpm", plastic),
             "J2, friction 0.5": ("thirty_grains_quasi_static_mpm", {**plastic, "Contact/Friction": 0.5})}
    drawn = {}
    print("| grains | packing | " + " | ".join(f"σ [MPa], Z, aspect ratio at {f}" for f in FRACTIONS) + " |\n" + "|---" * (2 + len(FRACTIONS)) + "|")
    for kind, (scene, changes) in kinds.items():
        for seed in words.packings:
            curve, values = assembly(words.program, words.folder, scene,
                                     f"{NAMES.get(words.number, words.number)}-{kind.replace(', friction ', '-')}-{seed}",
                                     {**changes, "Packing/Seed": seed}, width)
            drawn[f"{kind}, {seed}"] = curve
            print(f"| {kind} | {seed} | " + " | ".join(f"{s / 1e6:.3f}, {z:.2f}, {a:.3f}" for s, z, a in values) + " |", flush=True)
    if words.picture:
        draw(words.picture, ones, drawn)


if __name__ == "__main__":
    main()
