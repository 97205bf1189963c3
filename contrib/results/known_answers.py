#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scenes whose answers are known and prints them beside each other, the table of doc/results/laws.md: first yield under a
line contact, a plastic block between smooth plates, fully plastic indentation, line contact of a Maxwell solid. Ends with 1 where one
is farther off than it may be."""
import math

import numpy as np

from running import parser_of, run, softgrain


SETTINGS = {}  # of the command line, for every run


def mises(xx, yy, xy, poisson):
    """Von Mises stress in plane strain."""
    zz = poisson * (xx + yy)
    return np.sqrt(((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 2 + 3 * xy**2)


def half_plane(poisson):
    """p0/Sy at first yield below Hertz's pressure on a half-plane (Johnson, Contact Mechanics, section 4.1)."""
    z = np.linspace(0.01, 3, 20001)
    root = np.hypot(1, z)
    return 1 / np.max(mises(-((1 + 2 * z**2) / root - 2 * z), -1 / root, 0, poisson))


def disk(poisson, ratio, n=4000):
    """The same for a disk between two such pressures, half width over radius @ratio: a pair of line forces on a disk has the
    stresses of two half-planes and an even tension of force/(pi R) (Timoshenko and Goodier, Theory of Elasticity, section 41)."""
    radius, angle = 1 / ratio, np.arange(1, n + 1) * math.pi / (n + 1)
    weight, turn = math.pi / (n + 1) * np.sin(angle) ** 2, np.cos(angle) * ratio  # Gauss's rule for the root of 1 - s^2
    y, worst = radius - np.linspace(0.2, 1.5, 261), 0.0
    for x in np.linspace(0, 0.6, 7):
        xx = yy = weight.sum() / (math.pi * radius)
        xy = 0.0
        for side in (1, -1):
            normal = -side * np.array([np.sin(turn), np.cos(turn)])
            arm = np.array([x + radius * normal[0] + 0 * y[:, None], y[:, None] + radius * normal[1]])
            share = -2 / math.pi * weight * (arm[0] * normal[0] + arm[1] * normal[1]) / (arm[0] ** 2 + arm[1] ** 2) ** 2
            xx = xx + (share * arm[0] ** 2).sum(axis=1)
            yy = yy + (share * arm[1] ** 2).sum(axis=1)
            xy = xy + (share * arm[0] * arm[1]).sum(axis=1)
        worst = max(worst, np.max(mises(xx, yy, xy, poisson)))
    return (weight * np.cos(turn)).sum() / (math.pi / 2) / worst


def first_yield(program, folder, poisson):
    """The force from which on there is plastic strain: the line through the first two states that have some, back to none. The arcs
    go as far as the compliance asks, so that for every ratio yield is where steps are short."""
    law, way = "Materials/steel/J2 plastic/", f"{4.8e-6 * (1 - poisson**2) / 0.91:.6g}*min(8*t, 0.8 + 0.5*(t - 0.1))"
    changes = {law + "Poisson's ratio": poisson, "Obstacles/lower/Displacement": f"0; {way}", "Obstacles/upper/Displacement": f"0; -{way}"}
    _, rows = run(program, "verification/first_yield.prm", folder, {**changes, **SETTINGS}, threads=1, again=False)
    times, forces = zip(*((row["time_s"], -row["lower_force_y_N_per_m"]) for row in rows))
    before, found = 0.0, []
    for state in softgrain.open(folder):
        force, strain = float(np.interp(state.time, times, forces)), float(np.max(state.points["equivalent_plastic_strain"]))
        if strain == 0.0:
            before = force
        else:
            found.append((force, strain))
    (force, strain), (force_2, strain_2) = found[:2]
    force = max(before, force - strain * (force_2 - force) / (strain_2 - strain))
    modulus, radius = 200e9 / (1 - poisson**2), 1 / (1 / 5e-3 - 1 / 5.4e-3)
    pressure = math.sqrt(force * modulus / (math.pi * radius))
    ratio = 2 * pressure * radius / modulus / 5e-3
    expected, ideal = disk(poisson, ratio), half_plane(poisson)
    found = pressure / 400e6
    return [(f"first yield, ν = {poisson}: p0/Sy of this disk, a/R = {ratio:.3f}", expected, found, 1),
            ("the same, carried over to a half-plane", ideal, found / expected * ideal, 1)]


def plastic_block(program, folder, hardening):
    changes = {"Materials/metal/J2 plastic/Hardening modulus": hardening}
    if hardening:
        changes |= {"Stop/Axial strain": 0.2, "Time/Time step": 5e-3}
    _, rows = run(program, "verification/plastic_block.prm", folder, {**changes, **SETTINGS}, threads=1, again=False)
    state = softgrain.open(folder)[-1]
    stress = rows[-1]["top_force_N_per_m"] * 10e-3 * math.exp(-rows[-1]["axial_strain"]) / float(np.sum(state.points["area_m2"]))
    strength = 200e6 + hardening * float(np.mean(state.points["equivalent_plastic_strain"]))
    return [(f"block between smooth plates, H/Sy = {hardening / 200e6:g}, strain {rows[-1]['axial_strain']:.3g}: stress/σ_y(α)",
             2 / math.sqrt(3), stress / strength, 1)]


def pressed_by(state, half):
    """Force [N/m] on the side of the contacts at @half(y)."""
    place = np.asarray(state.contacts["place_m"])
    return np.abs(np.asarray(state.contacts["force_N_per_m"])[half(place[:, 1]), 1]).sum()


def touching_width(outline, centre, radius, near=1e-6):
    """Half the width [m] over which an outline is nearer than @near to an arc."""
    there = np.hypot(outline[:, 0], outline[:, 1] - centre) - radius < near
    x = outline[there & (outline[:, 1] < centre) & (outline[:, 1] > centre - 1.1 * radius), 0]
    return np.ptp(x) / 2 if x.size else 0.0


def indentation(program, folder):
    run(program, "verification/line_indentation.prm", folder, SETTINGS, threads=1, again=False)
    answers = []
    for state in softgrain.open(folder):
        outline = np.asarray(state.outlines.rings[0]).reshape(-1, 2)
        half = touching_width(outline, 18e-3 - state.time, 8e-3)
        if half == 0.0:
            continue
        found, plastic = pressed_by(state, lambda y: y > 5e-3) / (2 * half) / 200e6, half / 8e-3 * 200e9 / 0.91 / 200e6
        print(f"  depth {1e6 * state.time:.0f} µm, E* a/(R Sy) = {plastic:.0f}: p/Sy = {found:.3f}")
        if plastic > 75:
            answers.append(found)
    print(f"  from 75 on: {min(answers):.3f} to {max(answers):.3f}")
    return [(f"fully plastic indentation: mean pressure/Sy, mean of {len(answers)} states", (2 + math.pi) / math.sqrt(3),
             sum(answers) / len(answers), 5)]


def hertz(x, z, half, load):
    """Stress along the load below Hertz's line contact (Johnson, Contact Mechanics, eq. (4.49))."""
    b = half**2 - x**2 + z**2
    root = np.sqrt(b**2 + 4 * x**2 * z**2)
    m, n = (root + b) / 2, (root - b) / 2
    return -2 * load / (math.pi * half**2) * np.sqrt(m) * (1 - (z**2 + n) / (m + n))


def instantaneous(radius, modulus, compliance, relaxed, time, load, share, n=120):
    """
    Stress along the load below a contact of a viscoelastic half-plane that grows under a constant load, as a function of x
    and z: that of elastic contacts as wide as it was, each change multiplied by how much has relaxed since (Lee and Radok 1960).
    """
    times = [time * i / n for i in range(n + 1)]
    halves = [share * math.sqrt(4 * radius * load * compliance(t) / math.pi) for t in times]

    def stress(x, z):
        fields = [hertz(x, z, half, math.pi * half**2 * modulus / (4 * radius * share**2)) for half in halves]
        changes = zip(times, times[1:], fields, fields[1:])
        return relaxed(time) * fields[0] + sum(relaxed(time - (t0 + t1) / 2) * (f1 - f0) for t0, t1, f0, f1 in changes)

    return stress


def maxwell(program, folder):
    """
    Half width a of the contact under a constant load. Disks are no half-planes: a² of an elastic one is smaller by about a/2R.
    So it is compared with a² of elastic disks whose contacts are as wide: this disk, before it creeps, under one and two loads.
    """
    radius, modulus = 5e-3, 30e6 / 0.91
    fine = {"Material points/Shape function": "quadratic", "Material points/Points per direction": 3, "Mesh/Cell size": 4e-4,
            "Mesh/Refine near contact": 3, **SETTINGS}

    def compliance(time):
        return 2 * (1 - 0.5 * math.exp(-0.5 * time)) / modulus

    def relaxed(time):
        return 0.5 + 0.5 * math.exp(-time)

    def widths(name, changes):
        """Half width over the radius, and a² over that of the formula, of every state; and the rows of the history."""
        _, rows = run(program, "verification/maxwell_contact.prm", folder / name, {**fine, **changes}, threads=1, again=False)
        full, found = max(row["top_force_N_per_m"] for row in rows), []
        for state in softgrain.open(folder / name):
            load = pressed_by(state, lambda y: y < 0)
            if load < 0.99 * full or found and state.time - found[-1][0] < 1e-3:
                continue
            half = math.sqrt(4 * radius * load * compliance(state.time) / math.pi)
            place, stress = np.asarray(state.points["position_m"]), np.asarray(state.points["stress_yy_Pa"])
            z = place[:, 1] + radius
            below = (np.abs(place[:, 0]) < half / 2) & (z > 0.2 * half) & (z < half)
            shares = np.linspace(0.92, 1.04, 49)
            misfit = []
            for share in shares:
                expected = instantaneous(radius, modulus, compliance, relaxed, state.time, load, share)
                misfit.append(((stress[below] - expected(place[below, 0], z[below])) ** 2).sum())
            best = min(max(int(np.argmin(misfit)), 1), len(shares) - 2)
            fit = np.polyfit(shares[best - 1:best + 2], misfit[best - 1:best + 2], 2)
            found.append((state.time, half / radius, (fit[1] / fit[0] / 2) ** 2))
        return found, rows

    creeping, rows = widths("creep", {})
    at_once = {"Stages/creep/Stop/End time": 1e-4, "Output/Fields every": 0}
    elastic = [creeping[0], widths("twice", {**at_once, "Walls/top/Pressure": 1.6e5})[0][0]]
    _, ratios, shares = zip(*elastic)
    ways = []
    for row in rows[1:]:
        load, half = row["top_force_N_per_m"], math.sqrt(4 * radius * row["top_force_N_per_m"] * compliance(row["time_s"]) / math.pi)
        way = load * compliance(row["time_s"]) / math.pi * (2 * math.log(4 * radius / half) - 1)
        ways.append((radius - row["top_position_m"]) / 2 / way)
    compared = [share / np.interp(ratio, ratios, shares) for _, ratio, share in creeping]
    print(f"  approach over expected: {min(ways):.4f} to {max(ways):.4f}")
    print("  a/R, a² over that of a half-plane: " + ", ".join(f"{ratio:.3f} {share:.4f}" for _, ratio, share in creeping + elastic[1:]))
    worst = [max(list_, key=lambda ratio: abs(ratio - 1)) for list_ in (ways, compared)]
    return [("Maxwell contact: approach over that of the formula, worst time", 1.0, worst[0], 1),
            ("the same: a² over that of an elastic disk with a contact as wide, worst time", 1.0, worst[1], 1)]


def main():
    parser = parser_of(__doc__, "known_answers")
    tasks = {"block": lambda p, f: plastic_block(p, f / "block", 0.) + plastic_block(p, f / "block-hard", 100e6),
             "yield": lambda p, f: [row for nu in (0.3, 0.45, 0.4999) for row in first_yield(p, f / f"yield-{nu}", nu)],
             "maxwell": lambda p, f: maxwell(p, f / "maxwell"),
             "indentation": lambda p, f: indentation(p, f / "indentation")}
    parser.add_argument("--only", nargs="+", choices=tasks, default=list(tasks))
    parser.add_argument("--set", action="append", default=[], metavar="PATH=VALUE", help="changes of every run")
    arguments = parser.parse_args()
    SETTINGS.update(setting.split("=", 1) for setting in arguments.set)
    table = []
    for name in arguments.only:
        table += tasks[name](arguments.program, arguments.folder)
        print(f"{name} done", flush=True)
    print("| what | expected | found | difference | limit |\n|---|---|---|---|---|")
    for what, expected, found, limit in table:
        print(f"| {what} | {expected:.4f} | {found:.4f} | {100 * (found / expected - 1):+.2f} % | {limit} % |")
    return int(any(abs(100 * (found / expected - 1)) > limit for _, expected, found, limit in table))


if __name__ == "__main__":
    raise SystemExit(main())
