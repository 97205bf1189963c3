#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs scenes whose answers are known and prints them beside each other, the table of doc/results/laws.md: first yield under a
line contact, a plastic block between smooth plates, fully plastic indentation, line contact of a Maxwell solid."""
import argparse
import math
import pathlib

import numpy as np

from running import run, softgrain


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
    """The force from which on there is plastic strain: the line through the first two states that have some, back to none."""
    law = "Materials/steel/J2 plastic/"
    changes = {law + "Poisson's ratio": poisson}
    _, rows = run(program, "verification/first_yield.prm", folder, changes, threads=1, again=False)
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
    return [(f"first yield, ν = {poisson}: p0/Sy of this disk, a/R = {ratio:.3f}", expected, found),
            (f"the same, carried over to a half-plane", ideal, found / expected * ideal)]


def plastic_block(program, folder, hardening):
    changes = {"Materials/metal/J2 plastic/Hardening modulus": hardening}
    if hardening:
        changes |= {"Stop/Axial strain": 0.2, "Time/Time step": 5e-3}
    _, rows = run(program, "verification/plastic_block.prm", folder, changes, threads=1, again=False)
    state = softgrain.open(folder)[-1]
    stress = rows[-1]["top_force_N_per_m"] * 10e-3 * math.exp(-rows[-1]["axial_strain"]) / float(np.sum(state.points["area_m2"]))
    strength = 200e6 + hardening * float(np.mean(state.points["equivalent_plastic_strain"]))
    return [(f"block between smooth plates, H/Sy = {hardening / 200e6:g}, strain {rows[-1]['axial_strain']:.3g}: stress/σ_y(α)",
             2 / math.sqrt(3), stress / strength)]


def widths(folder):
    """Of every state: force upwards on the lower side of what presses, and the square of half widths of an even and of an elliptic
    pressure that have its second moment."""
    for state in softgrain.open(folder):
        contacts = state.contacts
        force = np.abs(np.asarray(contacts["force_N_per_m"])[:, 1])
        place = np.asarray(contacts["place_m"])
        yield state, force, place


def indentation(program, folder):
    run(program, "verification/line_indentation.prm", folder, {}, threads=1, again=False)
    answers = []
    for state, force, place in widths(folder):
        above = (place[:, 1] > 6e-3) & (force > 0)
        if not above.any():
            continue
        half = (np.max(place[above, 0]) - np.min(place[above, 0])) / 2
        answers.append((half, force[above].sum() / (2 * half) / 200e6))
    for half, found in answers:
        print(f"  a/R = {half / 8e-3:.4f}, E* a/(R Sy) = {half / 8e-3 * 200e9 / 0.91 / 200e6:.0f}: p/Sy = {found:.3f}")
    return [("fully plastic indentation: mean pressure/Sy", (2 + math.pi) / math.sqrt(3), answers[-1][1])]


def maxwell(program, folder):
    run(program, "verification/maxwell_contact.prm", folder, {}, threads=1, again=False)
    answers = []
    for state, force, place in widths(folder):
        for side in (-1, 1):
            there = (side * place[:, 1] > 0) & (force > 0)
            load = force[there].sum()
            if load < 999:
                continue
            mean = 4 * (force[there] * place[there, 0] ** 2).sum() / load
            compliance = 0.91 / 30e6 * 2 * (1 - 0.5 * math.exp(-0.5 * state.time))
            answers.append((state.time, mean, 4 * 5e-3 * load * compliance / math.pi))
    for time, found, expected in answers:
        print(f"  t = {time:.3f} s: a/R = {math.sqrt(found) / 5e-3:.4f}, a²/expected = {found / expected:.4f}")
    worst = max(answers, key=lambda answer: abs(answer[1] / answer[2] - 1))
    return [(f"Maxwell contact, worst at t = {worst[0]:.3g} s: a² [mm²]", worst[2] * 1e6, worst[1] * 1e6)]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("program", help="build/release/bin/softgrain")
    parser.add_argument("folder", nargs="?", type=pathlib.Path, default=pathlib.Path("output/known_answers"),
                        help="for the output folders of the runs (default: %(default)s)")
    tasks = {"block": lambda p, f: plastic_block(p, f / "block", 0.) + plastic_block(p, f / "block-hard", 100e6),
             "yield": lambda p, f: [row for nu in (0.3, 0.45, 0.4999) for row in first_yield(p, f / f"yield-{nu}", nu)],
             "maxwell": lambda p, f: maxwell(p, f / "maxwell"),
             "indentation": lambda p, f: indentation(p, f / "indentation")}
    parser.add_argument("--only", nargs="+", choices=tasks, default=list(tasks))
    arguments = parser.parse_args()
    table = []
    for name in arguments.only:
        table += tasks[name](arguments.program, arguments.folder)
        print(f"{name} done", flush=True)
    print("| what | expected | found | difference |\n|---|---|---|---|")
    for what, expected, found in table:
        print(f"| {what} | {expected:.4f} | {found:.4f} | {100 * (found / expected - 1):+.2f} % |")


if __name__ == "__main__":
    main()
