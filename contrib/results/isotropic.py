#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Isotropic compaction of 300 soft disks without friction and without inertia, two walls moving, several packings:
coordination, pressure at the walls and from contacts, and fits, for doc/results/quasi-static.md."""
import math

import numpy as np
import quasi_static
from running import parser_of, run, softgrain
from softgrain.contacts import NONE

E = 10e6  # Young's modulus [Pa]
SIDE = 35.8e-3  # of the box at the start [m]
CELL = 3.2e-4  # [m]
B_OF_ONE_GRAIN, GAMMA_OF_ONE_GRAIN = 0.118, (4.7, 4.0)  # single_grain.py, Γ at Φ = 0.84 and 0.86
SPEED = 2.5  # of the two walls [m/s]; without inertia only their way in a step counts


def changes(seed, fraction, end, every, friction):
    step = 0.3 * CELL / SPEED
    # The pressure takes area from the disks, so that they are undeformed denser at the end.
    seconds = SIDE * (1 - math.sqrt(fraction / 1.15)) / SPEED
    return {
        "Time/Scheme": "quasi_static", "Time/Time step": step, "Packing/Packing fraction": fraction,
        "Packing/Seed": seed, "Walls/top/Velocity": SPEED, "Walls/right/Velocity": SPEED, "Stop/Packing fraction": end,
        "Stop/End time": seconds, "Output/Fields every": 0, "Output/Snapshots every": every * step,
        "Output/History every": 1000, **quasi_static.friction(friction)}


def measure(state, diameters):
    """Φ of undeformed and of deformed disks, coordination without rattlers, three pressures [Pa]."""
    walls = {str(name): k for k, name in enumerate(state.walls.name)}
    place = {name: float(np.ravel(state.walls.position_m)[k]) for name, k in walls.items()}
    force = {name: abs(float(np.ravel(state.walls.normal_force_N_per_m)[k])) for name, k in walls.items()}
    width, height = place["right"] - place["left"], place["top"] - place["bottom"]
    area = width * height
    at_walls = 0.25 * ((force["top"] + force["bottom"]) / width + (force["left"] + force["right"]) / height)
    pairs, center = state.pairs, state.bodies.center_m
    pressed = pairs.normal_force_N_per_m > 0
    first, second, wall, place_of, force_of = (
        column[pressed] for column in (pairs.body_a, pairs.body_b, pairs.wall, pairs.place_m, pairs.force_N_per_m))
    with_wall = wall != NONE
    branch = np.where(with_wall[:, None], place_of, center[second]) - center[first]
    n = len(center)
    alive = np.ones(n, dtype=bool)
    while True:  # bodies with fewer than two contacts carry nothing
        count = np.zeros(n, dtype=int)
        carrying = alive[first] & (with_wall | alive[second])
        np.add.at(count, first[carrying], 1)
        np.add.at(count, second[carrying & ~with_wall], 1)
        poor = alive & (count < 2)
        if not poor.any():
            break
        alive[poor] = False
    # Of the grains away from walls: those at a wall have fewer neighbours.
    margin = 1.5 * float(np.mean(diameters))
    inner = alive & np.all((center > [place["left"] + margin, place["bottom"] + margin]) &
                           (center < [place["right"] - margin, place["top"] - margin]), axis=1)
    coordination = count[inner].mean() if inner.any() else 0.0
    solid = math.pi / 4 * float(np.sum(diameters**2))
    # ΦZ⟨fℓ⟩/(π⟨d²⟩) with Z the number of ends of contacts per body: a contact with a wall has one end, and counts once.
    z = 2 * len(first) / n
    mean = np.mean(np.linalg.norm(force_of, axis=1) * np.linalg.norm(branch, axis=1)) if len(first) else 0.0
    formula = solid / area * z * mean / (math.pi * np.mean(diameters**2))
    virial = np.abs((force_of * branch).sum(axis=1)).sum() / (2 * area)
    return (solid / area, float(np.sum(state.bodies.area_m2)) / area, coordination, at_walls, virial, formula)


def power_law(x, y, starts):
    """The start x0 of @starts for which log y is most nearly a line in log(x - x0); x0 and the slope."""
    best = (math.inf, math.nan, math.nan)
    for x0 in starts:
        line, error = np.polyfit(np.log(x - x0), np.log(y), 1, full=True)[:2]
        best = min(best, (float(error[0]), x0, float(line[0])))
    return best[1:]


def fit(phi, z, p):
    """Of Z - Z0 = k (Φ - Φ0)^β: Φ0 and β with Z0 = 4; Z0 and k with β = 1/2 and that Φ0; the exponent of P with that Φ0."""
    loaded = np.flatnonzero((p > 2e-4 * E) & (z > 4.05))
    phi0, beta = power_law(phi[loaded], z[loaded] - 4.0,
                           np.arange(phi[loaded[0]] - 0.03, phi[loaded[0]] - 5e-4, 2.5e-4))
    k, z0 = np.polyfit(np.sqrt(phi[loaded] - phi0), z[loaded], 1)
    near = loaded[phi[loaded] < phi0 + 0.06]
    return phi0, beta, z0, k, float(np.polyfit(np.log(phi[near] - phi0), np.log(p[near]), 1)[0])


def compare_with_one_grain(curves, phi0s):
    """P/E = -(b/2Γ) Z Φ ln((Φmax - Φ)/(Φmax - Φ0)) (Cantor et al. 2020), with b and Γ of one grain between four plates."""
    print("\n| b, Γ | r.m.s. error over P at the end, Φ above 0.84 |\n|---|---|")
    every = [(rows[:, 1], rows[:, 2], rows[:, 3] / E, phi0) for rows, phi0 in zip(curves, phi0s)]
    above = [(phi[phi > 0.84], z[phi > 0.84], p[phi > 0.84], phi0) for phi, z, p, phi0 in every]
    p = np.concatenate([one[2] for one in above])
    end = np.mean([one[2][-1] for one in above])
    shape = np.concatenate([-0.5 * z * phi * np.log((1 - phi) / (1 - phi0)) for phi, z, _, phi0 in above])
    fitted = float(shape @ shape / (shape @ p)) * B_OF_ONE_GRAIN
    for gamma in (*GAMMA_OF_ONE_GRAIN, fitted):
        error = np.sqrt(np.mean((B_OF_ONE_GRAIN / gamma * shape - p)**2)) / end
        print(f"| {B_OF_ONE_GRAIN}, {gamma:.2f}{' (fitted)' if gamma == fitted else ''} | {100 * error:.1f} % |")


def main():
    parser = parser_of(__doc__, "isotropic")
    parser.add_argument("--seeds", type=int, nargs="+", default=(1, 2, 3, 4, 5))
    parser.add_argument("--from", dest="start", type=float, default=0.75, help="packing fraction of the packings")
    parser.add_argument("--to", type=float, default=0.95, help="packing fraction at which runs end")
    parser.add_argument("--every", type=int, default=3, help="steps between states that are written, in balance")
    parser.add_argument("--friction", type=float, default=0.0)
    parser.add_argument("--threads", type=int, default=1)
    arguments = parser.parse_args()
    curves, fits, cost = [], [], []
    for seed in arguments.seeds:
        folder = arguments.folder / f"seed-{seed}-friction-{arguments.friction}"
        summary, _ = run(arguments.program, "thesis/uniaxial_compaction_mpm.prm", folder,
                         changes(seed, arguments.start, arguments.to, arguments.every, arguments.friction),
                         threads=arguments.threads, again=False)
        states = softgrain.open(folder).snapshots
        diameters = np.sqrt(4 / math.pi * np.asarray(states[0].bodies.reference_area_m2))
        rows = np.array([measure(state, diameters) for state in states])
        curves.append(rows)
        loaded = rows[rows[:, 3] > 2e-3 * E]
        worst = [np.max(np.abs(loaded[:, k] / loaded[:, 3] - 1)) for k in (4, 5)]
        fits.append(f"| {seed} | " + " | ".join(f"{x:.3f}" for x in fit(rows[:, 0], rows[:, 2], rows[:, 3]))
                    + f" | {100 * worst[0]:.2f} % | {100 * worst[1]:.2f} % |")
        cost.append(f"| {seed} | {summary['steps']} | {summary['wall_seconds']:.0f} |")
        print(fits[-1], cost[-1], flush=True)
    print("\n| packing | Φ0 | β | Z0 for β = 1/2 | k for it | exponent of P | virial against walls | ΦZ⟨fℓ⟩/(π⟨d²⟩) against walls |\n"
          + "|---" * 8 + "|\n" + "\n".join(fits))
    print("\n| packing | steps | seconds |\n|---|---|---|\n" + "\n".join(cost))
    print("\nMeans of the packings:\n\n| Φ of undeformed disks | Φ | Z | P/E |\n|---|---|---|---|")
    for phi in np.arange(0.82, 0.985, 0.02):
        values = [[np.interp(phi, rows[:, 0], rows[:, k]) for k in (1, 2, 3)] for rows in curves]
        mean, spread = np.mean(values, axis=0), np.std(values, axis=0)
        print(f"| {phi:.2f} | {mean[0]:.3f} | {mean[1]:.2f} ± {spread[1]:.2f} | {mean[2] / E:.2e} ± {spread[2] / E:.1e} |")
    if not arguments.friction:
        compare_with_one_grain(curves, [fit(rows[:, 1], rows[:, 2], rows[:, 3])[0] for rows in curves])
    np.savetxt(arguments.folder / f"isotropic-friction-{arguments.friction}.csv", np.vstack([
        np.column_stack([np.full(len(rows), seed), rows]) for seed, rows in zip(arguments.seeds, curves)]), delimiter=",",
        fmt="%.6g", comments="", header="packing,phi_undeformed,phi,coordination,p_walls_Pa,p_virial_Pa,p_formula_Pa")


if __name__ == "__main__":
    main()
