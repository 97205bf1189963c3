# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What `softgrain check` foretells of every shipped scene, and what the run then takes: within a factor of two.

    forecasts.py PROGRAM PARAMETERS FOLDER [SCENE...] [--table FILE]

Runs that take many minutes end sooner, which check is told too. `--table` writes the rows of these scenes into doc/results/forecast.md,
each as soon as it is known.
"""
import argparse
import json
import pathlib
import re
import resource
import shutil
import subprocess
import sys
import time

# Scenes that are too long for a night among others: how they end sooner.
SHORTER = {
    "thesis/biaxial_compression_bpm": ["Stages/compact/Stop/End time=2e-6", "Stages/compact/Stop/Equilibrium=0",
                                       "Stages/shear/Stop/Shear strain=1e-6"],
    "thesis/diametral_compression_mpm_thesis_method": ["Stop/End time=3e-4"],
    "thesis/uniaxial_compaction_mpm": ["Stop/End time=3e-4"],
    "thesis/uniaxial_compaction_mpm_friction": ["Stop/End time=3e-4"],
    "thesis/uniaxial_compaction_mpm_thesis_method": ["Stop/End time=2e-6"],
    "thesis/diametral_compression_bpm": ["Stop/End time=1e-3"],
    "thesis/diametral_compression_bpm_narrow": ["Stop/End time=1e-3"],
    "thesis/diametral_compression_bpm_wide": ["Stop/End time=1e-3"],
    "thesis/diametral_unloading_bpm": ["Stop/End time=1e-3"],
    "thesis/diametral_unloading_bpm_30": ["Stop/End time=1e-3"],
    "thesis/uniaxial_compaction_bpm": ["Stop/End time=2e-6"],
    "thesis/uniaxial_compaction_bpm_friction": ["Stop/End time=2e-6"],
}
UNITS = {"s": 1, "min": 60, "h": 3600, "MB": 1e6, "GB": 1e9, "TB": 1e12, "million": 1e6}


class RunFailed(Exception):
    """A run that does not come to its end, with its own words."""


def number(text):
    """Of "about 3.4 MB", "about 2 min 05 s"."""
    pairs = re.findall(r"([\d.e+-]+)\s*([A-Za-z]*)", text.removeprefix("about "))
    return sum(float(value) * UNITS.get(unit, 1) for value, unit in pairs)


def rounded(seconds):
    return f"{seconds:.0f}" if seconds >= 10 else f"{seconds:.2g}"


def processor_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def foretold(program, scene, settings):
    """What check foretells; None where it says that it does not know how long the run goes on."""
    begin = time.monotonic()
    before = processor_seconds()
    text = subprocess.run([program, "check", scene, *settings], capture_output=True, text=True, check=True).stdout
    lines = dict(re.split(r"\s{2,}", line.strip(), maxsplit=1) for line in text.splitlines() if line.startswith("  "))
    if lines["simulated time"].startswith("unknown"):
        return None
    return {"steps": number(lines["steps"]), "seconds": number(lines["processor time"]), "bytes": number(lines["memory"]),
            "points": number(lines.get("material points", lines.get("primaries"))),
            "check": processor_seconds() - before, "wall": time.monotonic() - begin}


def taken(program, scene, settings, folder):
    before = processor_seconds()
    done = subprocess.run([program, "run", scene, *settings, "--threads", "1", "--output", folder, "--overwrite"],
                          capture_output=True, text=True, check=False)
    if done.returncode:
        raise RunFailed(done.stderr.strip())
    summary = json.loads((folder / "summary.json").read_text())
    return {"steps": summary["steps"], "seconds": processor_seconds() - before, "bytes": summary["peak_memory_bytes"],
            "points": summary.get("material_points", summary.get("primaries"))}


def write_row(table, row):
    """Puts a row in the place of that of the same scene, or at the end."""
    text = table.read_text()
    scene = row.split("|")[1]
    old = [line for line in text.splitlines() if line.startswith("|") and line.split("|")[1].split(",")[0].strip() == scene.split(",")[0].strip()]
    table.write_text(text.replace(old[0], row) if old else text.rstrip("\n") + "\n" + row + "\n")


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("parameters", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--table", type=pathlib.Path)
    parser.add_argument("scenes", nargs="*")
    words = parser.parse_args()
    shutil.rmtree(words.folder, ignore_errors=True)
    lines, wrong = [], 0
    for path in sorted(words.parameters.rglob("*.prm")):
        name = str(path.relative_to(words.parameters).with_suffix(""))
        if name.startswith("studies/") or words.scenes and not any(part in name for part in words.scenes):
            continue
        if re.search(r"^set Dimension *= 3", path.read_text(), re.MULTILINE):
            continue  # what a scene in space costs is not foretold
        settings = [word for setting in SHORTER.get(name, []) for word in ("--set", setting)]
        before = foretold(words.program, path, settings)
        if before is None:
            continue
        try:
            after = taken(words.program, path, settings, words.folder / name.replace("/", "_"))
        except RunFailed as error:
            wrong += 1
            print(f"| {name} | WRONG: {error}", flush=True)
            continue
        ratios = {key: before[key] / after[key] for key in ("points", "steps", "seconds", "bytes")}
        bad = [key for key, ratio in ratios.items() if not 0.5 <= ratio <= 2]
        # A second of processor time: a busy machine may need more.
        bad += ["check"] if before["check"] > 1 else []
        wrong += bool(bad)
        scene = name.split("/")[1] + (f", {SHORTER[name][0].rsplit('/', 1)[1]}" if name in SHORTER else "")
        lines.append(f"| {scene} | {before['points']:.0f} / {after['points']} | {before['steps']:.0f} / {after['steps']} | "
                     f"{rounded(before['seconds'])} / {rounded(after['seconds'])} | {before['bytes'] / 1e6:.0f} / {after['bytes'] / 1e6:.0f} |")
        if words.table:
            write_row(words.table, lines[-1])
        print(lines[-1], "WRONG: " + ", ".join(bad) if bad else "", flush=True)
    print(f"{len(lines)} scenes, {wrong} wrong")
    sys.exit(1 if wrong or not lines else 0)


main()
