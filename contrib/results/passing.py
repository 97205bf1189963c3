#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Bodies that must not pass through each other: two disks in a shaft, and a body within another one. Prints the two tables of
"Bodies in each other" in doc/results/extremes.md.

    passing.py PROGRAM [--folder output/passing] [--limit 100]

A run is `right` when it comes to its end with the bodies where they belong; `seen` when it ends with both bodies, the place and
the depth; `passes` when it comes to its end and they are elsewhere. Anything else is told as the run says it.
"""
import argparse
import dataclasses
import itertools
import math
import pathlib
import re
import resource
import subprocess

SCENES = pathlib.Path(__file__).resolve().parents[2] / "tests/values/scenes"
DENSITY, GRAVITY, CELL = 1000, 9.81, 5e-4
SEEN = re.compile(r"body '\S+' and body '\S+' lie \S+ cells deep in each other at \(")


@dataclasses.dataclass
class Outcome:
    verdict: str
    depth: float = math.nan  # the largest of the run, in cells
    numbers: tuple = ()
    seconds: float = 0.0


def processor_seconds():
    spent = resource.getrusage(resource.RUSAGE_CHILDREN)
    return spent.ru_utime + spent.ru_stime


def outcome(options, name, scene, settings, judge, cell=CELL):
    """Runs a scene with at most so many seconds of processor time. @judge says of the last state (whether it is right, numbers)."""
    folder, before = options.folder / name, processor_seconds()
    words = [str(options.program), "run", str(SCENES / scene), "--threads", "1", "--overwrite", "--output", str(folder)]
    for setting in settings:
        words += ["--set", setting]
    limit = (options.limit, options.limit + 5)
    done = subprocess.run(words, capture_output=True, text=True, check=False,
                          preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, limit))
    seconds = processor_seconds() - before
    if done.returncode == 0:
        from running import softgrain  # needs numpy, which --help does not
        run = softgrain.open(str(folder))
        right, numbers = judge(run[-1])
        return Outcome("right" if right else "passes", run.summary["max_penetration_m"] / cell, numbers, seconds)
    if seconds > options.limit - 1:
        return Outcome(f"no end in {options.limit} s", seconds=seconds)
    said = done.stderr.strip().removeprefix("softgrain: error: ").split("; the last good state")[0]
    return Outcome("seen" if SEEN.search(said) else re.split(r" \('|;", said)[0], seconds=seconds)


def shafts(options):
    """One disk on another in a shaft, by the load on the upper one, cells and steps."""
    print("| load over mass, m/s² | right of nine | seen | other | upper above lower, mm | bottom bears of the load, off by at most | "
          "deepest, cells | longest, s |\n" + "|---" * 8 + "|")
    for load in (1e3, 1e4, 1e5):
        found = []
        for cell, step in itertools.product((1e-3, 5e-4, 3.5e-4), (0.2, 0.1, 0.03)):
            def judge(state):
                low, high = state.bodies.center_m[:, 1]
                borne = state.walls.normal_force_N_per_m[0] / (load * DENSITY * math.pi * 0.005**2)
                return 4e-3 < high - low < 10e-3 and abs(borne - 1) < 1e-3, (1e3 * (high - low), abs(borne - 1))
            name = f"shaft-{load:g}-{cell:g}-{step:g}"
            found.append(outcome(options, name, "shaft.prm", [f"Bodies/high/Body force=0; -{load:g}*t", f"Mesh/Cell size={cell}",
                                                              f"Time/Time step={step}"], judge, cell))
            tell(name, found[-1])
        right = [one for one in found if one.verdict == "right"]
        seen = sum(one.verdict == "seen" for one in found)
        others = "; ".join(one.verdict for one in found if one.verdict not in ("right", "seen")) or "0"
        above = [one.numbers[0] for one in right] or [math.nan]
        print(f"| {load:g} | {len(right)} | {seen} | {others} | {min(above):.2f} to {max(above):.2f} | "
              f"{max((one.numbers[1] for one in right), default=math.nan):.0e} | {deepest(right)} | "
              f"{max(one.seconds for one in found):.0f} |", flush=True)


def tell(name, one):
    print(f"<!-- {name}: {one.verdict}, {one.depth:.2g} cells, {one.numbers}, {one.seconds:.1f} s -->", flush=True)


def deepest(outcomes):
    return f"{max((one.depth for one in outcomes), default=math.nan):.4f}"


def arc(outer, inner, opening, n):
    """A C that is open at the top."""
    angles = [math.pi / 2 + opening / 2 + (2 * math.pi - opening) * k / n for k in range(n + 1)]
    return [(r * math.cos(a), r * math.sin(a)) for r, way in ((outer, 1), (inner, -1)) for a in angles[::way]]


def slit_frame():
    a, b, s = 0.010, 0.007, 0.001
    return [(-s, a), (-a, a), (-a, -a), (a, -a), (a, a), (s, a), (s, b), (b, b), (b, -b), (-b, -b), (-b, b), (-s, b)]


def polygon(name, corners, x=0.0, y=0.0):
    points = "; ".join(f"{x + p:.9g}, {y + q:.9g}" for p, q in corners)
    zeros = ["Radius"] + (["Inner radius"] if name == "ring" else [])
    return [f"Bodies/{name}/{key}=0" for key in zeros] + [f"Bodies/{name}/Center=0, 0", f"Bodies/{name}/Shape=polygon",
                                                          f"Bodies/{name}/Vertices={points}"]


def area(corners):
    return abs(sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(corners, corners[1:] + corners[:1]))) / 2


C, FRAME = arc(0.010, 0.007, 0.6, 40), slit_frame()
PENTAGON = [(0.003 * math.cos(0.3 + 2 * math.pi * k / 5), 0.003 * math.sin(0.3 + 2 * math.pi * k / 5)) for k in range(5)]
OUTER = {"ring": (None, math.pi * (0.01**2 - 0.007**2)), "C": (C, area(C)), "frame with a slit": (FRAME, area(FRAME))}
INNER = {"disk": math.pi * 0.003**2, "ellipse": math.pi * 0.003 * 0.002, "pentagon": area(PENTAGON)}


def settings_of(outer, inner, lying):
    """Bodies about (0, 10 mm) where they lie and about 0 where they are thrown; what lies begins a hair above what it lies on."""
    up = 0.010 if lying else 0.0
    drop = 0.0
    if lying:
        drop = {"disk": -0.004, "ellipse": -0.005, "pentagon": -0.0039}[inner] + (3e-5 if outer == "C" else 0)
    found = polygon("ring", OUTER[outer][0], 0, up) if OUTER[outer][0] else []
    if inner == "disk":
        found.append(f"Bodies/disk/Center=0, {up + drop:.9g}")
    elif inner == "ellipse":
        found += [f"Bodies/disk/Center=0, {up + drop:.9g}", "Bodies/disk/Shape=ellipse", "Bodies/disk/Radius=0",
                  "Bodies/disk/Semi-axes=3e-3, 2e-3"]
    else:
        found += polygon("disk", PENTAGON, 0, up + drop)
    return found


def nests(options):
    """A body within another one, lying or thrown."""
    ways = list(itertools.product(("lying", "thrown"), (0, 0.5)))
    print("\n| in | what | " + " | ".join(f"{how}, friction {mu:g}" for how, mu in ways) + " |\n" + "|---" * 6 + "|")
    for outer, inner in itertools.product(OUTER, INNER):
        weight = GRAVITY * DENSITY * (OUTER[outer][1] + INNER[inner])
        cells = []
        for how, mu in ways:
            def judge(state):
                (x, y), (u, v) = state.bodies.center_m
                apart = math.hypot(u - x, v - y)
                if how == "lying":
                    borne = state.walls.normal_force_N_per_m[0] / weight
                    return apart < 7e-3 and abs(borne - 1) < 1e-3, (1e3 * apart, abs(borne - 1))
                speed = state.bodies.velocity_m_per_s[0, 0]
                return apart < 5e-3 and speed > 0.01, (1e3 * apart, speed)
            name = f"{outer.split()[0]}-{inner}-{how}-{mu:g}"
            more = ["Stop/End time=0.016"] if how == "thrown" else []
            scene = "disk_in_ring.prm" if how == "lying" else "disk_thrown_in_ring.prm"
            one = outcome(options, name, scene, [*settings_of(outer, inner, how == "lying"), f"Contact/Friction={mu:g}", *more], judge)
            tell(name, one)
            cells.append(f"{one.verdict}, {one.depth:.1g}" if one.verdict in ("right", "passes") else one.verdict)
        print(f"| {outer} | {inner} | " + " | ".join(cells) + " |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--folder", type=pathlib.Path, default=pathlib.Path("output/passing"))
    parser.add_argument("--limit", type=int, default=100, help="seconds of processor time for a run")
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    shafts(options)
    nests(options)


if __name__ == "__main__":
    main()
