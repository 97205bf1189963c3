#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Tables of doc/results/thesis-5.md and biaxial.md from runs of chapter_five.py and simple_shear.py: steady states, how well walls
keep their pressure, unloading, cycles, contacts at rest; and small files of their curves. Stresses of bonded primaries are means over history.csv, whose steps are
many more than the states that are measured."""
import argparse
import csv
import math
import pathlib
import re
import statistics
import sys

import chapter_five_packings as packings
import numpy as np
from running import PYTHON, softgrain

sys.path.insert(0, str(PYTHON))
from softgrain.contacts import NONE  # noqa: E402
from softgrain.figures.paths import STEADY, constants_of, groups_of, line, not_fitted, read_path, stages_of  # noqa: E402

WINDOW = 0.02  # of shear strain, over which the curves of bonded primaries are averaged
ROWS = 5  # of the history, over which their stresses are averaged in cycles
KEPT = ("shear_strain", "volume_strain", "wall_pressure_Pa", "wall_stress_ratio", "stress_ratio", "packing_fraction",
        "coordination_of_bodies", "specific_contact_surface", "shape_strain", "shape_anisotropy", "contact_anisotropy",
        "normal_force_anisotropy", "tangential_force_anisotropy", "predicted_stress_ratio", "sliding_contacts")
PREDICTED = "(a_c + a_f (+ a_t))/2"


def row(*cells):
    return "| " + " | ".join(map(str, cells)) + " |"


def head(*names):
    return row(*names) + "\n" + "|---" * len(names) + "|"


def walls_of(output, begin, end):
    """Time, its weights, shear strain and stresses on the four walls between two times, of history.csv."""
    history = output.history_table
    kept = (history["time_s"] > begin * (1 + 1e-9)) & (history["time_s"] <= end * (1 + 1e-9))
    part = {name: values[kept] for name, values in history.items()}
    width, height = (part[f"{b}_position_m"] - part[f"{a}_position_m"] for a, b in (("left", "right"), ("bottom", "top")))
    stress = {wall: part[f"{wall}_force_N_per_m"] / (width if wall in ("bottom", "top") else height)
              for wall in ("bottom", "top", "left", "right")}
    strain = np.log(width / height)
    return part["time_s"], strain - strain[0], stress


def curve(path, begin, end):
    """Shear strain and q/p of a stage; of bonded primaries running means."""
    _, strain, stress = walls_of(path.output, begin, end)
    one, two = 0.5 * (stress["top"] + stress["bottom"]), 0.5 * (stress["left"] + stress["right"])
    if path.model == "mpm":
        return strain, (one - two) / (one + two)
    sense = 1 if strain[-1] > 0 else -1
    places = np.arange(0, abs(strain[-1]), 0.5 * WINDOW)
    near = [np.abs(sense * strain - place) < 0.5 * WINDOW for place in places]
    mean = [(one[k].mean() - two[k].mean()) / (one[k].mean() + two[k].mean()) for k in near]
    return sense * places, np.array(mean)


def parts_of(path):
    """(name, begin, end) of the stages after the isotropic one."""
    stages = stages_of(path.output)
    first = next(k for k, (name, *_) in enumerate(stages) if name == "shear")
    return stages[first:]


def pm(values, digits=3):
    return f"{np.mean(values):.{digits}f} ± {np.std(values):.{digits}f}"


class Steady:
    """The steady state of a run: the last of these shares of its shear strain."""

    def __init__(self, path):
        self.path = path
        self.begin, self.end = parts_of(path)[0][1:]
        self.strain, self.ratio = curve(path, self.begin, self.end)
        self.late = self.strain >= (1 - STEADY[0]) * self.strain[-1]
        strain = path.shear["shear_strain"]
        self.states = strain >= (1 - STEADY[0]) * strain[-1]

    def column(self, name):
        return self.path.shear[name][self.states]

    def right_wall(self):
        """Of its stress over what is asked for."""
        _, strain, stress = walls_of(self.path.output, self.begin, self.end)
        return stress["right"][strain >= (1 - STEADY[0]) * strain[-1]].mean() / self.path.pressure - 1

    def with_branches(self, most=12):
        """q/p of Σ f l over contacts between bodies: (5.16) is what is left of it where all branches l are equal."""
        snapshots, times = self.path.output.snapshots, self.path.shear["time_s"][self.states]
        places = np.unique([int(np.argmin(np.abs(snapshots.times - t))) for t in times])
        return np.mean([ratio_of_branches(snapshots[k]) for k in places[::max(1, len(places) // most)]])


def ratio_of_branches(state):
    pairs, centre = state.pairs, state.bodies.center_m
    kept = (pairs.wall == NONE) & (pairs.normal_force_N_per_m > 0)
    branch, force = centre[pairs.body_b[kept]] - centre[pairs.body_a[kept]], pairs.force_N_per_m[kept]
    force = force * np.sign(np.sum(force * branch, axis=1))[:, None]
    stress = np.einsum("ki,kj->ij", force, branch)
    least, largest = np.linalg.eigvalsh(0.5 * (stress + stress.T))
    return (largest - least) / (largest + least)


def name_of(path):
    return pathlib.Path(path.output.directory).name


STEADY_HEAD = head("run", "p_c over stiffness", "Φ, isotropic", "Z, isotropic", "ε_q reached", "q/p, steady", "largest q/p",
                   "Φ, largest", "Φ, steady", "Z, steady")
CHECKS_HEAD = head("run", "q/p of moments", PREDICTED, "q/p of f·l", "right wall over p_c", "p of moments over that of walls",
                   "energy balance", "released [J/m]", "of walls [J/m]", "seconds")


def steady_row(steady):
    path, fraction, peak = steady.path, steady.path.shear["packing_fraction"], np.argmax(steady.ratio)
    return row(name_of(path), f"{path.kappa:.3g}", f"{path.isotropic['packing_fraction']:.3f}",
               f"{path.isotropic['coordination_of_bodies']:.2f}", f"{steady.strain[-1]:.2f}", pm(steady.ratio[steady.late]),
               f"{steady.ratio[peak]:.2f} at {steady.strain[peak]:.2f}", f"{fraction.max():.3f}",
               pm(steady.column("packing_fraction")), pm(steady.column("coordination_of_bodies"), 2))


def checks_row(steady):
    path = steady.path
    moments = steady.column("mean_pressure_Pa").mean() / steady.column("wall_pressure_Pa").mean() - 1
    summary = path.output.summary if path.output.summary.get("status") == "completed" else {}
    released = path.output.history_table.get("released_energy_J_per_m", [math.nan])[-1]
    return row(name_of(path), pm(steady.column("stress_ratio")), f"{steady.column(predicted(path)).mean():.3f}",
               f"{steady.with_branches():.3f}", f"{steady.right_wall():+.2%}", f"{moments:+.2%}",
               f"{summary.get('energy_balance_error', math.nan):.1e}", f"{released:.2g}",
               f"{path.shear['external_work_J_per_m'][-1]:.3g}", f"{summary.get('wall_seconds', math.nan):.0f}")


SHAPE_HEAD = head("run", "q, steady [MPa]", "η before", "η at the end", "η of a disk that follows the box",
                  "contacts won per strain", "motion beside the box, diameters per strain", "a_c", "a_f", "a_t")


def shape_row(steady):
    path, shape = steady.path, steady.path.shear["shape_strain"]
    contacts, motion, *anisotropies = (np.nanmean(steady.column(name)) for name in (
        "contacts_won_per_strain", "nonaffine_displacement_per_strain", "contact_anisotropy", "normal_force_anisotropy",
        "tangential_force_anisotropy"))
    return row(name_of(path), f"{steady.column('wall_deviator_Pa').mean() / 1e6:.3f}", f"{shape[0]:.3f}", f"{shape[-1]:.3f}",
               f"{math.tanh(0.5 * path.shear['shear_strain'][-1]):.3f}", f"{contacts:.2f}", f"{motion:.1f}",
               *(f"{anisotropy:.2f}" for anisotropy in anisotropies))


def predicted(path):
    """Column of (5.16)."""
    return "predicted_stress_ratio" if path.friction > 0 else "half_sum_of_anisotropies"


MEAN_HEAD = head("runs", "p_c over stiffness", "packings", "Φ, isotropic", "Z, isotropic", "q/p", "Φ, steady", "Z, steady",
                 PREDICTED)


def mean_table(paths):
    """Steady states of runs that differ in their seed alone."""
    groups = {}
    for path in paths:
        groups.setdefault((path.model, path.grains or 0, path.friction, float(f"{path.pressure:.2g}")), []).append(path)
    lines = [MEAN_HEAD]
    for _, group in sorted(groups.items()):
        def over(function, digits=3, group=group):
            values = [function(path) for path in group]
            scatter = f" ± {statistics.stdev(values):.{digits}f}" if len(values) > 1 else ""
            return f"{statistics.mean(values):.{digits}f}{scatter}"

        def steady(name):
            return lambda path: float(np.nanmean(Steady(path).column(name)))
        lines.append(row(group[0].group, f"{group[0].kappa:.3g}", len(group),
                         over(lambda p: p.isotropic["packing_fraction"]), over(lambda p: p.isotropic["coordination_of_bodies"], 2),
                         over(steady("wall_stress_ratio")), over(steady("packing_fraction")),
                         over(steady("coordination_of_bodies"), 2), over(steady(predicted(group[0])))))
    return lines


def unloading_row(path):
    (_, begin, turn), (_, _, end) = parts_of(path)[:2]
    (_, up), (strain, down) = curve(path, begin, turn), curve(path, turn, end)
    late = np.abs(strain) >= (1 - STEADY[0]) * abs(strain[-1])
    lowest = np.argmin(down)
    before, after = (part["packing_fraction"] for part in (path.shear, path.unloading))
    return row(name_of(path), f"{up[-1]:.3f}", f"{down[lowest]:.3f} at {abs(strain[lowest]):.2f}", pm(down[late]),
               f"{before[-1]:.3f}", f"{after.min():.3f}", f"{after[-1]:.3f}")


UNLOADING_HEAD = head("run", "q/p where it turns", "least q/p, shear strain after the turn", "q/p at the end", "Φ where it turns",
                      "least Φ", "Φ at the end")


HELD_HEAD = head("way back", "p at its start, at its end [MPa]", "least q/p, shear strain after the turn", "q/p at the end", "least over end",
                 "Φ at its start, least, at its end")


def held_row(folder):
    """The stage "unload" of a run that may have begun there, as with --hold-mean."""
    output = softgrain.open(folder)
    _, begin, end = next(stage for stage in stages_of(output) if stage[0] == "unload")
    _, _, stress = walls_of(output, begin, end)
    strain, down = curve(argparse.Namespace(output=output, model=output.model), begin, end)
    late, lowest = np.abs(strain) >= (1 - STEADY[0]) * abs(strain[-1]), np.argmin(down)
    pressure = 0.25e-6 * sum(stress.values())
    part, history = max(1, len(pressure) // 20), output.history_table
    fraction = history["packing_fraction"][(history["time_s"] >= begin) & (history["time_s"] <= end * (1 + 1e-9))]
    return row(pathlib.Path(folder).name, f"{pressure[:part].mean():.3f}, {pressure[-part:].mean():.3f}", f"{down[lowest]:.3f} at {abs(strain[lowest]):.2f}",
               pm(down[late]), f"{down[lowest] / down[late].mean():.2f}", f"{fraction[0]:.3f}, {fraction.min():.3f}, {fraction[-1]:.3f}")


def work_of_walls(history, rows):
    """By trapezoids, over the steps between two rows of the history [J/m]."""
    part = {name: values[rows[0]:rows[1] + 1] for name, values in history.items()}
    work = 0.
    for wall, sense in (("top", -1), ("right", -1), ("bottom", 1), ("left", 1)):
        force, way = part[f"{wall}_force_N_per_m"], np.diff(part[f"{wall}_position_m"])
        work += sense * float(np.sum(0.5 * (force[1:] + force[:-1]) * way))
    return work


CYCLES_HEAD = head("cycle", "ε_q from, to", "q/p from, to", "Φ", "work of walls by trapezoids [J/m]", "dissipated [J/m]",
                   "of it released [J/m]", "stored at its end [J/m]")


def cycle_table(path):
    lines = [CYCLES_HEAD]
    stages, history = parts_of(path)[1:], path.output.history_table
    _, begin, _ = parts_of(path)[0]
    for k in range(len(stages) // 2):
        start, end = stages[2 * k][1], stages[2 * k + 1][2]
        times, strain, stress = walls_of(path.output, begin, end)
        kept = times >= start * (1 - 1e-9)
        one, two = 0.5 * (stress["top"] + stress["bottom"])[kept], 0.5 * (stress["left"] + stress["right"])[kept]
        if path.model == "bpm":  # single steps are noisy
            one, two = (np.convolve(stress, np.full(ROWS, 1 / ROWS), "same") for stress in (one, two))
        ratio, strain = (one - two) / (one + two), strain[kept]
        rows = [int(np.argmin(np.abs(history["time_s"] - t))) for t in (start, end)]
        none = np.full(len(history["time_s"]), math.nan)  # bonded primaries book nothing as released
        change = {name: np.diff(np.asarray(history.get(f"{name}_energy_J_per_m", none))[rows])[0]
                  for name in ("released", "dissipated")}
        lines.append(row(k + 1, f"{strain.min():.3f}, {strain.max():.3f}", f"{ratio.min():.3f}, {ratio.max():.3f}",
                         f"{history['packing_fraction'][rows[1]]:.4f}", f"{work_of_walls(history, rows):.4f}",
                         f"{change['dissipated']:.4f}", f"{change['released']:.4f}",
                         f"{history['elastic_energy_J_per_m'][rows[1]]:.3f}"))
    return lines


CONTACTS_HEAD = head("run", "states", "Z of single states", "contacts that bear a force in any", "mean force above a tenth of the mean")


def contacts_row(path):
    """Contacts between grains in the second half of the isotropic stage: those of bonded grains flicker from step to step."""
    _, begin, end = next(stage for stage in stages_of(path.output) if stage[0] == "compact")
    snapshots, forces, single = path.output.snapshots, {}, []
    places = np.flatnonzero((snapshots.times >= 0.5 * (begin + end)) & (snapshots.times <= end * (1 + 1e-9)))
    for place in places:
        pairs = snapshots[int(place)].pairs
        kept = (pairs.wall == NONE) & (pairs.normal_force_N_per_m > 0)
        single.append(kept.sum())
        for a, b, force in zip(pairs.body_a[kept], pairs.body_b[kept], pairs.normal_force_N_per_m[kept]):
            forces[min(a, b), max(a, b)] = forces.get((min(a, b), max(a, b)), 0.) + force
    mean, share = np.array(list(forces.values())), 2 / path.grains
    return row(name_of(path), len(places), *(f"{share * number:.2f}" for number in (
        np.mean(single), len(mean), (mean > 0.1 * mean.mean()).sum())))


RAMP = (("packing_fraction", 3), ("void_ratio", 3), ("coordination_of_bodies", 2))
RANGES = ((0.25, 1.2), (2 / 11, 32 / 11), (0.25, 5.))  # of p/p_I; the second is that of the thesis
RAMP_HEAD = head("run", "p/p_I", "states", "Φ (5.2)", "e (5.3)", "Z (5.4)", "Z over e (5.5)")


def ramp_of(path):
    """p/p_I from the walls and the columns of RAMP while the pressure of --slow-ramp rises."""
    measures = path.output.measures_table
    _, begin, end = next(stage for stage in stages_of(path.output) if stage[0] == "press")
    kept = (measures["time_s"] >= begin) & (measures["time_s"] <= end * (1 + 1e-9))
    return measures["wall_pressure_Pa"][kept] / path.stiffness, {name: measures[name][kept] for name, _ in RAMP}


def ramp_rows(path):
    """Lines through the isotropic states of a slow ramp, over log10(p/p_I), in ranges of it; r.m.s. distance in brackets."""
    ratio, columns = ramp_of(path)

    def fit(x, y, digits, text):
        start, slope, off = line(x, y)
        return f"{start:.{digits}f} {slope:+.{digits}f} {text} ({off:.3f})"
    for low, high in RANGES:
        kept = (ratio >= low) & (ratio <= high)
        states = {name: values[kept] for name, values in columns.items()}
        yield row(name_of(path), f"{low:.2g} to {min(high, ratio.max()):.2g}", kept.sum(),
                  *(fit(np.log10(ratio[kept]), states[name], digits, "log") for name, digits in RAMP),
                  fit(states["void_ratio"], states["coordination_of_bodies"], 1, "e"))


def write_ramp(path, folder):
    """Every second state as a small file."""
    ratio, columns = ramp_of(path)
    with open(folder / f"thesis-5-{name_of(path)}.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["pressure_over_stiffness", *columns])
        writer.writerows([f"{value:.5g}" for value in values] for values in list(zip(ratio, *columns.values()))[::2])


SIMPLE_HEAD = head("run", "q/p of moments", "σ_xy/σ_yy", "Φ", "Z", "(a_c + a_f + a_t)/2")


def simple_row(folder):
    """Steady simple shear: the last 30 % of the way."""
    output = softgrain.open(folder)
    measures, (_, begin, end) = output.measures_table, stages_of(output)[-1]
    late = (measures["time_s"] >= begin + (1 - STEADY[0]) * (end - begin)) & (measures["time_s"] <= end * (1 + 1e-9))
    column = {name: measures[name][late] for name in measures}
    return row(pathlib.Path(folder).name, pm(column["stress_ratio"]), pm(np.abs(column["stress_xy_Pa"] / column["stress_yy_Pa"])),
               pm(column["packing_fraction"]), pm(column["coordination_of_bodies"], 2),
               f"{np.nanmean(column['predicted_stress_ratio']):.3f}")


def write_curve(path, folder):
    """Columns of the shear stage as a small file; every second state of long runs."""
    name = name_of(path)
    columns = [column for column in KEPT if column in path.shear]
    step = max(1, len(path.shear["shear_strain"]) // 40)
    with open(folder / f"thesis-5-{name}.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(columns)
        for i in range(0, len(path.shear["shear_strain"]), step):
            writer.writerow([f"{path.shear[column][i]:.5g}" for column in columns])


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("runs", type=pathlib.Path, nargs="*", help="output folders")
    parser.add_argument("--curves", type=pathlib.Path, help="folder for small files of their curves")
    parser.add_argument("--packings", type=pathlib.Path, metavar="FILE",
                        help="means over packings, of the small file that the runs are written to; without runs only of the file")
    parser.add_argument("--picture", type=pathlib.Path, help="PNG file for what --packings has")
    arguments = parser.parse_args()
    simple = [run for run in arguments.runs if run.name.startswith("simple-")]
    held = [run for run in arguments.runs if run.name.endswith("-mean")]
    paths = [path for path in (read_path(str(run)) for run in arguments.runs if run not in simple + held) if path.shear]
    cycled = [path for path in paths if re.search("-cycles", path.output.directory)]
    turned = [path for path in paths if path.unloading and path not in cycled]
    ramps = [path for path in paths if name_of(path).endswith("-ramp")]
    straight = [path for path in paths if path not in turned + cycled + ramps]
    straight.sort(key=lambda path: (path.model, path.friction, path.pressure))
    if straight:
        steady = [Steady(path) for path in straight]
        print("\n".join([STEADY_HEAD, *map(steady_row, steady), "", CHECKS_HEAD, *map(checks_row, steady), "", SHAPE_HEAD,
                         *map(shape_row, steady), ""]))
        print("\n".join([*mean_table(straight), ""]))
        bonded = [path for path in straight if path.model == "bpm"]
        if bonded:
            print("\n".join([CONTACTS_HEAD, *map(contacts_row, bonded), ""]))
        for group in groups_of(straight):
            if not_fitted(group):
                continue
            found = constants_of(group)
            numbers = ", ".join(f"{name} {value:.3g}" for name, value in found.items() if value is not None)
            print(f"{group[0].group}: {numbers}")
    if turned:
        print("\n".join(["", UNLOADING_HEAD, *map(unloading_row, turned)]))
    if held:
        beside = [run.with_name(run.name[:-len("-mean")]) for run in held]
        print("\n".join(["", HELD_HEAD, *(held_row(run) for pair in zip(beside, held) for run in pair)]))
    if ramps:
        print("\n".join(["", RAMP_HEAD, *(text for path in ramps for text in ramp_rows(path))]))
    for path in cycled:
        print("\n".join(["", *cycle_table(path)]))
    if simple:
        print("\n".join(["", SIMPLE_HEAD, *map(simple_row, simple)]))
    if arguments.packings:
        if straight:
            packings.write(straight, walls_of, arguments.packings)
        print("\n".join(["", *packings.table(arguments.packings)]))
        if arguments.picture:
            packings.draw(arguments.packings, arguments.picture)
    if arguments.curves:
        for path in straight:
            write_curve(path, arguments.curves)
        for path in ramps:
            write_ramp(path, arguments.curves)


if __name__ == "__main__":
    main()
