# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Every list of a checkpoint is damaged in seven ways and the file sealed again: --restart refuses it with one line that names the
list, or, where the list of contents is made to fit, at least never crashes. Checkpoints of both models, with all that states
can have. Quick: some lists in one way each; with SOFTGRAIN_ALL_DAMAGES all in all ways.
"""
import os
import re
import shutil
import subprocess
import unittest
import zlib

import h5py
import numpy as np

import whole_runs
from whole_runs import PARAMETERS, PROGRAM, WORK

ALL = "SOFTGRAIN_ALL_DAMAGES" in os.environ
FIELDS = ["Output/Number of field outputs=0", "Output/Fields every=0", "Output/Snapshots every=0"]
WALLS = ["Walls/Names=bottom, top, left, right", "Walls/bottom/Point=0, -5.2e-3", "Walls/top/Point=0, 5.2e-3",
         "Walls/left/Point=-10.2e-3, 0", "Walls/right/Point=10.2e-3, 0", "Walls/top/Drive=pressure",
         "Walls/top/Pressure=1e4", "Walls/top/Mass=1"]
PLATE = ["Obstacles/Names=plate", "Obstacles/plate/Points=-9e-3, -5.01e-3; 9e-3, -5.01e-3"]
CELL = ["Mesh/Cell size=6.4e-4", "Packing/Number=16", "Packing/Packing fraction=0.7", "Stages/compress/Stop/End time=3.2e-5",
        "Stages/shear/Stop/End time=1.28e-4"]
GRAINS = ["Packing/Smallest diameter=1.75e-3", "Packing/Largest diameter=1.75e-3", "Primaries/Variants=2"]
# File, settings; the time at which the run that goes on ends.
SCENES = {
    # A ring and a disk, friction, bonds, plastic flow, an obstacle, walls under pressure.
    "mpm": ("gallery/two_disks.prm",
            ["Mesh/Cell size=2e-3", "Bodies/left/Inner radius=2.5e-3", "Bodies/left/Center=-4.99e-3, 0",
             "Materials/gel/Law=j2_plastic", "Contact/Friction=0.3", "Contact/Law=bond", "Contact/Adhesion=1e4",
             "Contact/Adhesion range=2e-5", "Contact/Healing time=1e-5", *WALLS, *PLATE, *FIELDS], "1e-4", "1.2e-4"),
    # A cell that repeats, stages, no friction.
    "mpm_cell": ("gallery/simple_shear_periodic.prm", [*CELL, *FIELDS], "6.4e-5", "7e-5"),
    # In balance, with memory of the stop conditions.
    "mpm_static": ("gallery/thirty_grains_quasi_static_mpm.prm",
                   ["Packing/Number=6", "Packing/Packing fraction=0.6", "Mesh/Cell size=6.4e-4", "Walls/top/Velocity=5",
                    *FIELDS], "6.4e-5", "1.28e-4"),
    # Bonded primaries that roll, with bonds between bodies, an obstacle, a wall under pressure.
    "bpm": ("gallery/one_grain_bpm.prm",
            ["Primaries/Number per body=40", "Stop/Axial strain=0", "Contact/Friction=0.3", "Contact/Rolling resistance=0.05",
             "Contact/Law=bond", "Contact/Adhesion=50", "Contact/Adhesion range=1e-5", "Contact/Healing time=1e-5",
             "Walls/Names=bottom, top, left, right", "Walls/left/Point=-2.1e-3, 0", "Walls/right/Point=2.1e-3, 0",
             "Walls/top/Drive=pressure", "Walls/top/Pressure=1e4", "Walls/top/Mass=1", "Walls/top/Velocity=0",
             "Obstacles/Names=plate", "Obstacles/plate/Points=-3e-3, -2e-3; 3e-3, -2e-3", *FIELDS], "5e-5", "6e-5"),
}
NO_TIME = {"mpm_cell"}  # the stages end it
KINDS = ("emptied", "halved", "doubled", "none", "type", "removed", "range")
# Lists that may be shorter or absent, that of a run that has seen less, and parameters that are compared by value.
FREE = re.compile(r"driver/parameters|stop_seen|stage_seen|contact/adhesion|bpm/adhesion|resistance|walls_sliding|build_cell|strength|"
                  r"output/(history|measures)")


def damaged(values, kind):
    """What becomes of a list; nothing where the kind makes no sense, False: it goes."""
    flat = np.asarray(values)
    if flat.dtype.kind == "S":
        text = flat.tobytes()
        change = {"emptied": b"", "halved": text[:len(text) // 2], "doubled": text + text, "type": 1., "removed": False}.get(kind)
        if change == text:  # nothing to empty, to halve or to double
            return None
        if change is None or change is False or isinstance(change, float):
            return np.array([change]) if isinstance(change, float) else change
        return np.array([change], dtype=f"S{len(change)}") if change else np.zeros(0, "S1")
    if kind in ("emptied", "halved", "doubled") and flat.size == 0:
        return None
    if kind == "none" or kind == "range":
        if flat.size == 0 or (kind == "none") != (flat.dtype.kind == "f"):
            return None
        changed = flat.copy()
        changed[-1 if kind == "none" else 0] = np.nan if kind == "none" else 2**63
        return changed
    return {"emptied": flat[:0], "halved": flat[:flat.size // 2], "doubled": np.concatenate([flat, flat]),
            "type": flat.astype("u8" if flat.dtype.kind == "f" else "f8"), "removed": False}[kind]


def sealed(path):
    with open(path, "r+b") as file:
        content = file.read()
        file.write(b"\nsoftgrain seal %08x\n" % zlib.crc32(content))


def write_list(file, name, values):
    del file[name]
    if values is False:
        return
    if values.dtype.kind == "S":
        kind = h5py.h5t.C_S1.copy()
        kind.set_size(max(values.dtype.itemsize, 1))
        kind.set_strpad(h5py.h5t.STR_NULLPAD)
        kind.set_cset(h5py.h5t.CSET_UTF8)
        space = h5py.h5s.create_simple((len(values),))
        plist = h5py.h5p.create(h5py.h5p.LINK_CREATE)
        plist.set_create_intermediate_group(True)
        made = h5py.h5d.create(file.id, name.encode(), kind, space, lcpl=plist)
        if len(values):
            made.write(h5py.h5s.ALL, h5py.h5s.ALL, values, kind)
    else:
        file.create_dataset(name, data=values, track_times=False)


def size_line(name, values):
    kind = {"f": "d", "u": "u", "S": "t"}[values.dtype.kind]
    return f"{name} {kind} {values.size * values.dtype.itemsize if kind == 't' else values.size}"


class DamagedStates(unittest.TestCase):
    def prepare(self, model):
        self.folder = WORK / f"damaged.{model}"
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir(parents=True)
        scene, self.settings, end, self.later = SCENES[model]
        self.ends = [] if model in NO_TIME else ["Stop/End time="]
        self.words = [PROGRAM, "run", PARAMETERS / scene, "--threads", "1"]
        done = self.run_it(end, "--output", self.folder / "good")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        good = max((self.folder / "good").glob("state-*.h5"))
        content = good.read_bytes()
        self.content = content[:content.rindex(b"\nsoftgrain seal")]
        with h5py.File(good) as file:
            self.lists = {}
            file.visititems(lambda name, item: self.lists.update({name: item[()]}) if isinstance(item, h5py.Dataset) else None)
            self.contents = file["contents"][()][0].decode().splitlines()
        # The undamaged one goes on, also when it is written again as damaged ones are.
        name = "driver/statistics"
        self.assertEqual(self.damage(name, self.lists[name], True).returncode, 0)

    def run_it(self, end, *words):
        settings = [*self.settings, *(key + end for key in self.ends)]
        sets = [word for setting in settings for word in ("--set", setting)]
        return subprocess.run([*self.words, *sets, *words], capture_output=True, text=True, check=False, errors="replace",
                              timeout=100)

    def damage(self, name, values, fits):
        state, out = self.folder / "state-000000001.h5", self.folder / "out"
        state.write_bytes(self.content)
        with h5py.File(state, "r+") as file:
            write_list(file, name, values)
            if fits:
                lines = [line for line in self.contents if line.rsplit(" ", 2)[0] != name]
                lines += [] if values is False else [size_line(name, values)]
                text = "".join(line + "\n" for line in lines).encode()
                write_list(file, "contents", np.array([text], dtype=f"S{len(text)}"))
        sealed(state)
        shutil.rmtree(out, ignore_errors=True)
        return self.run_it(self.later, "--restart", state, "--output", out)

    def check(self, model):
        self.prepare(model)
        n, accepted = 0, []
        lists = sorted(self.lists.items())
        for position, (name, values) in enumerate(lists if ALL else lists[::max(1, len(lists) // 14)]):
            for kind in KINDS if ALL else [KINDS[position % len(KINDS)]]:
                changed = damaged(values, kind)
                if changed is None:
                    continue
                for fits in (False, True) if ALL else (position % 2 == 0,):
                    if name == "contents" and fits:
                        continue
                    n += 1
                    done = self.damage(name, changed, fits)
                    what = (model, name, kind, fits, done.stderr)
                    self.assertIn(done.returncode, (0, 1, 2), what)
                    if done.returncode == 0:
                        accepted.append((name, kind, fits))
                        continue
                    self.assertRegex(done.stderr, r"\Asoftgrain: error: [^\n]+\n\Z", what)
        print(f"{model}: {n} damages of {len(self.lists)} lists; accepted with a list of contents that fits: {accepted}")
        # Without a new list of contents only numbers are left that could have been.
        self.assertEqual([one for one in accepted if not one[2] and one[1] != "range"], [])
        self.assertEqual([one for one in accepted if one[1] != "range" and not FREE.search(one[0])], [])

    def test_mpm(self):
        self.check("mpm")

    def test_mpm_cell(self):
        self.check("mpm_cell")

    def test_mpm_static(self):
        self.check("mpm_static")

    def test_bpm(self):
        self.check("bpm")


whole_runs.main()
