# SPDX-License-Identifier: LGPL-2.1-or-later
"""What must hold of every single run: its end, its numbers, bodies beside each other, energy and momentum."""
import json
import math
import re

import numpy

import polygons
from runs import by_name, outlines

# A run may end before its time for a reason that the scene or the input has. Each is said in one line.
CAUSES = [
    r"leaves? the (background )?mesh|left the (background )?mesh|out of the (background )?mesh|room in the mesh",
    r"the cell that repeats has become too small",
    r"holds? (the )?body|nothing holds",
    r"leaves? no room|closed? on",
    r"turned inside out|inverted|collapse|no stress|volume",
    r"grow(s|n|th)",
    r"would slide|slid as far|under that stress|bears the (load|stress|pressure|shear stress)",
    r"lie[s]? in each other|crosses|passed through|deep(er)? in",
]
# A scene may be refused for what only the program can find out.
REFUSALS = [r"the attraction of its \d+ primaries draws body '.*' together"]
EMPTY = ("axial_strain", "packing_fraction")  # there is none without walls
OVERLAP = 0.25       # cells, or mean diameters of primaries [what the parameters allow is 0.1 and 0.02]
ENERGY = 1e-3        # of the largest energy
OVERLAPS = 1e-6      # of the energy of attraction
ENERGY_NEW_GRID = 2e-2  # where points are laid on new grids, which takes and gives energy
MOMENTUM = 1e-6      # of the largest momentum


def spacing_of(scene):
    """A cell, or the mean diameter of the primaries: what lengths are measured by."""
    if scene.get("Model") == "bpm":
        return (scene.number("Primaries/Smallest diameter") + scene.number("Primaries/Largest diameter")) / 2
    return scene.number("Mesh/Cell size")


def end(run):
    """What is wrong with the way in which a run has ended: (kind, what was seen), or nothing."""
    if run.code == 0:
        return None
    if run.code == 124:
        return "hang", f"no end after {run.seconds:.0f} s of processor time"
    if run.code not in (1, 2):
        return "crash", f"exit code {run.code}: {run.message[-200:]}"
    lines = run.message.splitlines()
    if len(lines) != 1 or not lines[0].startswith("softgrain: error: ") or re.search(r"\bnan\b|deal\.?ii|assert|terminate",
                                                                                    lines[0], re.IGNORECASE):
        return "message", run.message[:300]
    text = lines[0].removeprefix("softgrain: error: ").split("; the last good state")[0]
    if run.code == 2:
        return None if any(re.search(reason, text) for reason in REFUSALS) else ("refused", text[:300])
    return None if any(re.search(cause, text) for cause in CAUSES) else ("unclear end", text[:300])


def not_finite(run):
    """Files in which there is something else than numbers."""
    found = []
    summary = (run.out / "summary.json").read_text()
    json.loads(summary)
    if re.search(r"\b(nan|inf(inity)?)\b", summary, re.IGNORECASE):
        found.append("summary.json")
    for name, column in run.history().items():
        if name not in EMPTY and not numpy.isfinite(column).all():
            found.append(f"history.csv: {name}")
    for index, snapshot in enumerate(run.snapshots()):
        for name, array in snapshot.items():
            if isinstance(array, numpy.ndarray) and array.dtype.kind == "f" and not numpy.isfinite(array).all():
                found.append(f"snapshot {index}: {name}")
    for path in sorted(run.out.glob("*.csv")):
        if re.search(r"(^|,)[-+]?(nan|inf)(,|$)", path.read_text(), re.IGNORECASE | re.MULTILINE):
            found.append(path.name)
    return ("not finite", "; ".join(found[:5])) if found else None


def images(scene, snapshot):
    """Ways to the images of a body in a cell that repeats, without the body itself."""
    if "walls/repeats" not in snapshot:
        return []
    place, repeats = by_name(snapshot, "walls", "position_m"), by_name(snapshot, "walls", "repeats")
    offset = max(by_name(snapshot, "walls", "offset_m").values(), key=abs)
    across = place["right"] - place["left"] if repeats.get("left") else 0.0
    up = place["top"] - place["bottom"] if repeats.get("bottom") else 0.0
    ways = [(i * across + j * offset, j * up) for i in ((-2, -1, 0, 1, 2) if across else (0,)) for j in ((-1, 0, 1) if up else (0,))]
    return [way for way in ways if way != (0.0, 0.0)]


def deepest_of_primaries(scene, snapshot):
    """(depth, what lies in what) where bodies are bonded primaries: what is between these, also in a hole, is in no body."""
    place, size = snapshot["points/position_m"], snapshot.get("points/extra/radius_m", numpy.zeros(0))
    body, names = snapshot["points/body"], list(by_name(snapshot, "bodies", "area_m2"))
    cell, found = spacing_of(scene), (0.0, "")
    for way in [(0.0, 0.0)] + images(scene, snapshot):
        apart = numpy.hypot(*(place[:, None] - place - way).transpose(2, 0, 1))
        deep = size[:, None] + size - apart
        if way == (0.0, 0.0):
            deep[body[:, None] == body] = 0
        i, j = numpy.unravel_index(deep.argmax(), deep.shape)
        found = max(found, (float(deep[i, j]) / cell, f"{names[body[i]]} and {names[body[j]]}"))
    for name, line in obstacle_lines(snapshot).items():
        deep = size - polygons.distance(place, line[:-1], line[1:])
        found = max(found, (float(deep.max()) / cell, f"obstacle {name} in {names[body[deep.argmax()]]}"))
    return found


def deepest_overlap(scene, snapshot):
    """(depth, what lies in what) of the deepest overlap of a snapshot, in cells."""
    if scene.get("Model") == "bpm":
        names = list(by_name(snapshot, "bodies", "area_m2"))
        beyond = max((depth / spacing_of(scene), f"beyond wall {name}") for b, rings in enumerate(outlines(snapshot))
                     for name, depth in {"": 0.0, **({} if is_driven(scene, names[b]) else walls_beyond(snapshot, rings))}.items())
        return max(beyond, deepest_of_primaries(scene, snapshot)) if "points/position_m" in snapshot else beyond
    cell, bodies = spacing_of(scene), outlines(snapshot)
    names, found = list(by_name(snapshot, "bodies", "area_m2")), (0.0, "")
    moved = images(scene, snapshot)
    for b, second in enumerate(bodies):
        for a, first in enumerate(bodies[:b + 1]):
            for way in ([(0.0, 0.0)] if a != b else []) + moved:
                other = [ring + way for ring in second] if way != (0.0, 0.0) else second
                found = max(found, (polygons.depth(first, other, cell / 4) / cell, f"{names[a]} and {names[b]}"))
        if is_driven(scene, names[b]):
            continue
        for name, beyond in walls_beyond(snapshot, second).items():
            found = max(found, (beyond / cell, f"{names[b]} beyond wall {name}"))
        for name, line in obstacle_lines(snapshot).items():
            places = polygons.line_places(line, cell / 4)
            found = max(found, (polygons.depth_of_places(places, second) / cell, f"obstacle {name} in {names[b]}"))
    return found


def is_driven(scene, body):
    """Driven bodies keep their way through walls and obstacles: nothing could stop either of the two."""
    return scene.get(f"Bodies/{body}/Driven") is True or scene.get(f"Bodies/{body}/Driven") == "true"


def walls_beyond(snapshot, rings):
    """How far a body reaches beyond each wall."""
    points, normals = by_name(snapshot, "walls", "point_m"), by_name(snapshot, "walls", "normal")
    repeats = by_name(snapshot, "walls", "repeats") if "walls/repeats" in snapshot else {}
    return {name: max(0.0, max(float(((point - ring) @ normals[name]).max()) for ring in rings))
            for name, point in points.items() if not repeats.get(name)}


def obstacle_lines(snapshot):
    if "obstacles/name" not in snapshot:
        return {}
    offsets = snapshot["obstacles/line_offsets"]
    return {name: snapshot["obstacles/points_m"][offsets[i]:offsets[i + 1]]
            for i, name in enumerate(by_name(snapshot, "obstacles", "angle_rad"))}


def overlap(scene, run, limit=OVERLAP):
    """Bodies that lie in each other, in walls or in obstacles, although the run says nothing of it."""
    deepest = (0.0, "")
    for index, snapshot in enumerate(run.snapshots()):
        depth, what = deepest_overlap(scene, snapshot)
        deepest = max(deepest, (depth, f"{what} at snapshot {index}"))
    if deepest[0] > limit:
        said = json.loads((run.out / "summary.json").read_text())["max_penetration_m"] / spacing_of(scene)
        return "overlap", f"{deepest[1]}: {deepest[0]:.3g} cells, the program says {said:.2g}"
    return None


def energy_rise(scene, run):
    """(rise, largest energy [J/m], snapshot): kinetic and stored energy, less the work from outside, may only fall."""
    scale, lowest, rise = 0.0, math.inf, (0.0, 0)
    snapshots = run.snapshots()
    stored = [float(numpy.ravel(s["energies/elastic_energy_J_per_m"])[0]) for s in snapshots]
    for index, snapshot in enumerate(snapshots):
        kinetic, work = (float(numpy.ravel(snapshot[f"energies/{name}_J_per_m"])[0]) for name in ("kinetic_energy", "external_work"))
        scale = max(scale, kinetic, abs(stored[index] - (stored[0] if scene.get("Model") == "bpm" else 0)), abs(work))
        total = kinetic + stored[index] - work
        lowest = min(lowest, total)
        rise = max(rise, (total - lowest, index))
    return rise[0], scale, rise[1]


def energy(scene, run):
    """Energy that comes from nothing. Where all energies are rounding, nothing can be said."""
    if any(path.endswith("Growth/Rate") for path in scene.values):
        return None
    rise, scale, index = energy_rise(scene, run)
    last = run.snapshots()[-1]
    if last["time_s"] == 0 or json.loads((run.out / "summary.json").read_text()).get("energy_balance_error") is None:
        return None
    rounding = 1e-10 * last["bodies/mass_kg_per_m"].sum() * (spacing_of(scene) / last["time_s"])**2
    if scene.get("Model") == "bpm":  # overlaps that aggregates begin with are pushed out: about 1e-5 diameters
        rounding += OVERLAPS * abs(float(numpy.ravel(run.snapshots()[0]["energies/elastic_energy_J_per_m"])[0]))
    limit = ENERGY if scene.get("Material points/Grid update", "never") == "never" else ENERGY_NEW_GRID
    if scale > rounding and rise > limit * scale:
        return "energy", f"{rise / scale:.2g} of {scale:.2g} J/m more at snapshot {index} than before, from nothing"
    return None


def energy_of_steps(scene, run, half):
    """
    Whether a rise of energy belongs to the step: schemes that are not implicit have energies that swing by the order of the
    step. With half the step it must then be smaller by far; and it must be small.
    """
    first, second = (energy_rise(scene, each) for each in (run, half))
    return half.code == run.code and first[0] < 0.05 * first[1] and second[0] / second[1] < 0.75 * first[0] / first[1]


def momentum(scene, run):
    """Momentum that no force from outside explains, where all of these are known."""
    free = not scene.names("Walls") and not scene.names("Obstacles")
    if scene.get("Time/Scheme") == "quasi_static" or not free or \
            any(path.endswith(("/Body force", "/Driven")) for path in scene.values):
        return None
    gravity, start, worst, scale = numpy.array(scene.point("Loads/Gravity")), None, (0.0, 0), 0.0
    for index, snapshot in enumerate(run.snapshots()):
        parts = snapshot["bodies/mass_kg_per_m"][:, None] * snapshot["bodies/velocity_m_per_s"]
        total = parts.sum(axis=0) - snapshot["bodies/mass_kg_per_m"].sum() * gravity * snapshot["time_s"]
        start = total if start is None else start
        scale = max(scale, float(numpy.abs(parts).sum()))
        worst = max(worst, (float(numpy.hypot(*(total - start))), index))
    if scale > 0 and worst[0] > MOMENTUM * scale:
        return "momentum", f"{worst[0] / scale:.2g} of the momentum has changed at snapshot {worst[1]}"
    return None


def judge(scene, run):
    """All that is wrong with a run, as (kind, what was seen)."""
    ended = end(run)
    found = [ended] if ended else []
    if run.code not in (0, 1) or not run.snapshots():
        return found
    bad = not_finite(run)
    if bad:
        return [*found, bad]
    return found + [seen for seen in (overlap(scene, run), energy(scene, run), momentum(scene, run)) if seen]
