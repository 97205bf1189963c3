# SPDX-License-Identifier: LGPL-2.1-or-later
"""One scene with the relations that it is asked for, and what came out."""
import random
import shutil
import time
import traceback

import cases
import checks
import relations
from generator import generate
from scene import Scene

RUN = "run"  # the name under which a single run is judged


def chosen(scene, most):
    """At most so many of the relations that apply, other ones for every seed."""
    apply = relations.that_apply(scene)
    if not most or len(apply) <= most:
        return apply
    dice = random.Random(f"relations {scene.note('seed')}")
    picked = dice.sample(range(len(apply)), most)
    return [apply[i] for i in sorted(picked)]


def of_the_step(case, kind):
    """
    Whether a rise of energy is one that goes with the step of a scheme that does not damp: the work of forces is the mean of both
    ends of a step.
    """
    damps = case.scene.get("Time/Scheme") == "moreau_jean" and case.scene.number("Time/Theta") != 0.5
    if kind != "energy" or damps or case.scene.get("Time/Scheme") == "quasi_static":
        return False
    half = case.run(cases.with_step(case.scene, 0.5), "half")
    return checks.energy_of_steps(case.scene, case.base, half)


def try_scene(scene, program, folder, asked=None, most=0):
    """Verdicts on a scene: dictionaries with relation, verdict, kind and what was seen."""
    found = []
    case = cases.Case(scene, program, folder)
    wanted = chosen(scene, most) if asked is None else [relations.BY_NAME[name] for name in asked if name != RUN]
    if asked is None or RUN in asked:
        wrong = [each for each in checks.judge(scene, case.base) if not of_the_step(case, each[0])]
        found += [{"relation": RUN, "verdict": "fails", "kind": kind, "seen": seen} for kind, seen in wrong]
        if not wrong:
            said = case.base.message.removeprefix("softgrain: error: ").split("; the last good state")[0]
            found.append({"relation": RUN, "verdict": "holds", "kind": "", "seen": said})
    for relation in wanted:
        if case.base.code == 0 or (relation.exact and case.base.code == 1 and case.base.snapshots()):
            found.append(vars(relation.ask(case)))
    return found


def try_seed(seed, program, folder, most, asked=None, wanted=lambda scene: True):
    """The record of a seed, or nothing when its scene is not wanted."""
    scene = program.fitted(generate(seed))
    if not wanted(scene):
        return None
    before, begin = program.seconds, time.monotonic()
    work = folder / f"scene-{seed}"
    record = {"seed": seed, "family": scene.note("family"), "model": scene.get("Model"),
              "scheme": scene.get("Time/Scheme", "bonded")}
    try:
        record["verdicts"] = try_scene(scene, program, work, asked, most)
    except Exception:  # a fault of the storm itself must not end the storm; it counts as a failure
        record["verdicts"] = [{"relation": RUN, "verdict": "fails", "kind": "storm", "seen": traceback.format_exc()[-1500:]}]
    shutil.rmtree(work, ignore_errors=True)
    record["seconds"] = round(program.seconds - before, 2)
    record["clock"] = round(time.monotonic() - begin, 2)
    return record


def fails_as(scene: Scene, program, folder, relation, kind):
    """What is seen when a scene still fails in this way, or nothing."""
    try:
        found = try_scene(scene, program, folder, [relation])
    except Exception:  # not every reduced scene leaves the files that a comparison reads
        return ""
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    return next((v["seen"] or kind for v in found
                 if v["verdict"] == "fails" and v["relation"] == relation and v["kind"] == kind), "")
