# SPDX-License-Identifier: LGPL-2.1-or-later
"""Runs on several ranks: what they write is that of one process, to the last bit, and a rank that is lost ends the run."""
import csv
import json
import os
import pathlib
import re
import resource
import shutil
import signal
import subprocess
import time
import unittest

import h5py

import whole_runs
from whole_runs import LONG_STEPS, MANY_STEPS, PARAMETERS, PROGRAM, WORK, states, status, wait_for_rows

MPIRUN = shutil.which("mpirun")
ENVIRONMENT = {**os.environ, "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
COARSE = "Mesh/Cell size=6.4e-4"
THIRTY = ["gallery/thirty_grains_mpm.prm", COARSE, "Walls/top/Velocity=20", "Output/Fields every=5e-5",
          "Output/Snapshots every=2.5e-5", "Stop/End time=5e-5"]
HELD = [COARSE, "Packing/Number=12", "Packing/Packing fraction=0.65"]
RAYS = ["Contact/Geometry=rays", "Quasi-static/Regularisation=1e-6"]
EQUAL = ["Packing/Smallest diameter=1.75e-3", "Packing/Largest diameter=1.75e-3", "Primaries/Variants=2"]
BONDED = ["gallery/thirty_grains_bpm.prm", *EQUAL]
BALLS = [f"Bodies/{name}/{setting}" for name, place in (("a", "6e-3, 7e-3, 8e-3"), ("b", "22e-3, 23e-3, 8.2e-3"), ("c", "22.1e-3, 7.1e-3, 24e-3"),
                                                       ("d", "6.2e-3, 23e-3, 23.7e-3"))
         for setting in ("Shape=sphere", f"Center={place}", "Radius=10.6e-3")]
# A few steps each: with friction, with history, with grids that are laid anew, with walls of points, in balance.
SCENES = {
    "two_disks": ["gallery/two_disks.prm", "Mesh/Cell size=1.2e-3", "Stop/End time=6e-4"],
    "thirty": THIRTY,
    "friction": [*THIRTY, "Contact/Friction=0.3"],
    # Grains touch from the start, so that bonds hold, slide and break.
    "adhesion": [*THIRTY, "Contact/Friction=0.3", "Contact/Law=bond", "Contact/Adhesion=1e4", "Contact/Adhesion range=2e-5",
                 "Contact/Healing time=1e-5"],
    "plastic": [*THIRTY, "Materials/gel/Law=j2_plastic", "Material points/Grid update=every step"],
    "explicit": [*THIRTY, "Stop/End time=2e-5", "Time/Scheme=explicit", "Time/CFL multiple=0.3", "Contact/Solver=lumped"],
    "quasi_static": ["gallery/thirty_grains_quasi_static_mpm.prm", *HELD, "Walls/top/Velocity=5", "Output/Fields every=0",
                     "Output/Snapshots every=6.4e-5", "Stop/End time=1.28e-4"],
    "biaxial": ["gallery/biaxial_thirty_grains_mpm.prm", *HELD, "Stages/compress/Stop/End time=6.4e-5",
                "Stages/shear/Stop/Axial strain=0.005"],
    "periodic": ["gallery/simple_shear_periodic.prm", COARSE, "Packing/Number=16", "Packing/Packing fraction=0.7",
                 "Stages/compress/Stop/End time=6.4e-5",
                 "Stages/shear/Stop/End time=1.28e-4"],
    # Rays need the field of the partner, wherever its points are.
    "rays": ["gallery/thirty_grains_quasi_static_mpm.prm", *HELD, *RAYS, "Contact/Friction=0.3", "Contact/Law=bond",
             "Contact/Adhesion=1e4", "Contact/Adhesion range=2e-5", "Contact/Healing time=1e-5", "Walls/top/Velocity=5",
             "Output/Fields every=0", "Output/Snapshots every=3.2e-5", "Stop/End time=6.4e-5"],
    "rays_hopper": ["gallery/hopper_mpm.prm", RAYS[0], "Contact/Friction=0.3", "Output/Fields every=0", "Packing/Number=12",
                    "Packing/Upper=38e-3, 66e-3", "Loads/Gravity=0, -50", "Material points/Grid update=every step"],
    # Where there are more than two thousand primaries, each rank has some of them.
    "bonded": [*BONDED, "Walls/top/Velocity=5", "Stop/End time=2e-5"],
    "bonded_friction": [*BONDED, "Walls/top/Velocity=5", "Contact/Friction=0.3", "Contact/Rolling resistance=0.05",
                        "Stop/End time=1e-5"],
    # Steps that are taken back, neighbours that change, a wall that gives way.
    "bonded_pressed": [*BONDED, "Walls/top/Velocity=60", "Walls/right/Drive=pressure", "Walls/right/Pressure=3e6",
                       "Loads/Gravity=1e5, -1e6", "Time/Time step=3e-6", "Contact/Largest penetration=0.002",
                       "Output/History every=1", "Stop/End time=3e-6"],
    "bonded_adhesion": [*BONDED, "Walls/top/Velocity=5", "Contact/Law=cohesive", "Contact/Adhesion=50", "Contact/Adhesion range=1e-5",
                        "Stop/End time=1e-5"],
    "bonded_grain": ["gallery/one_grain_bpm.prm", "Walls/top/Velocity=5", "Stop/End time=1e-4"],
    "bonded_cell": ["gallery/simple_shear_periodic_bpm.prm", *EQUAL, "Stages/compact/top/Drive=velocity",
                    "Packing/Packing fraction=0.84", "Stages/compact/top/Velocity=60", "Stages/compact/top/Pressure=0",
                    "Stages/compact/right/Drive=velocity", "Stages/compact/right/Pressure=0",
                    "Stages/compact/Stop/End time=2e-5", "Stages/shear/top/Drive=velocity", "Stages/shear/top/Pressure=0",
                    "Stages/shear/Stop/End time=1e-5"],
    # Loads of a body's own are known to its rank alone; of what is driven all ranks have the points.
    "pushed": ["gallery/two_disks.prm", "Mesh/Cell size=1.2e-3", "Stop/End time=6e-4", "Bodies/left/Driven=true",
               "Bodies/right/Body force=-2e4*(1+50*X); 1e4*y*t"],
    # In space: balls that rub in a cell that is pressed and sheared, balls that fall, and metal.
    "cell_of_balls": ["gallery/sheared_cell_of_spheres.prm", "Mesh/Cell size=4.5e-3", "Time/Wall way=.1", "Packing/Number=0",
                      "Bodies/Names=a, b, c, d", *BALLS, "Contact/Friction=.3", "Output/Snapshots every=.4", "Stop/End time=1.2"],
    "moving_balls": ["gallery/poured_spheres.prm", "Mesh/Cell size=2.7e-3", "Loads/Gravity=0, 0, -90", "Packing/Number=5",
                     "Output/Snapshots every=4e-3", "Stop/End time=0.012"],
    "explicit_balls": ["gallery/poured_spheres.prm", "Mesh/Cell size=2.7e-3", "Loads/Gravity=0, 0, -90", "Packing/Number=5",
                       "Time/Scheme=explicit", "Time/Time step=1.5e-4", "Output/Snapshots every=2e-3", "Stop/End time=6e-3"],
    "plastic_balls": ["gallery/twelve_plastic_spheres.prm", "Mesh/Cell size=.3", "Output/Snapshots every=2e-3", "Stop/End time=4e-3"],
    "thesis_method": ["gallery/two_disks.prm", "Mesh/Cell size=1.2e-3", "Materials/gel/Law=linear_elastic",
                      "Material points/Shape function=linear", "Material points/Fill limit=0.01",
                      "Material points/Grid update=every step", "Contact/Geometry=nodes", "Contact/Nodal gap=false",
                      "Contact/Solver=lumped", "Time/Scheme=newmark", "Time/Time step=1e-5", "Stop/End time=3e-4"],
}


def words(scene, folder, settings=(), more=()):
    file, *own = scene
    sets = [word for setting in [*own, *settings] for word in ("--set", setting)]
    return [PROGRAM, "run", PARAMETERS / file, "--threads", "1", "--output", folder, *sets, *more]


def launch(ranks, command):
    """None: no launcher at all."""
    return command if ranks is None else [MPIRUN, "--oversubscribe", "-n", str(ranks), *command]


def data_of(path):
    """Every data set of an HDF5 file, as bytes; but for the time a run took, and the name of its folder."""
    found = {}

    def note(name, item):
        if isinstance(item, h5py.Dataset) and name not in ("driver/statistics", "driver/processor_seconds", "driver/parameters"):
            value = item[()]
            if name == "contents":  # but for the size of what is left out above: it has the name of the folder
                value = re.sub(rb"driver/parameters t \d+\n", b"", value[0])
            found[name] = (item.shape, value.tobytes() if hasattr(value, "tobytes") else value)

    with h5py.File(path) as file:
        file.visititems(note)
    return found


@unittest.skipIf(MPIRUN is None, "there is no mpirun")
class RankRuns(unittest.TestCase):
    def setUp(self):
        self.base = WORK / self.id().split(".", 1)[1]
        shutil.rmtree(self.base, ignore_errors=True)
        self.base.mkdir(parents=True)

    def run_on(self, ranks, scene, name, settings=(), more=(), expect=0):
        folder = self.base / name
        done = subprocess.run(launch(ranks, words(scene, folder, settings, more)), capture_output=True, text=True,
                              check=False, env=ENVIRONMENT, timeout=200)
        self.assertEqual(done.returncode, expect, done)
        if expect == 0:
            # A launcher of another MPI starts so many runs of one rank each, which agree with each other.
            self.assertEqual(json.loads((folder / "summary.json").read_text())["ranks"], ranks or 1)
            self.assertEqual(re.findall(r"(\d+) ranks, each with 1 threads", done.stdout),
                             [str(ranks)] if ranks and ranks > 1 else [])
        return folder, done

    def assert_same_data(self, one, other):
        first, second = data_of(one), data_of(other)
        self.assertEqual(list(first), list(second))
        self.assertGreater(len(first), 0)
        self.assertEqual([name for name in first if first[name] != second[name]], [], other)

    def assert_same(self, one, other):
        self.assertEqual((one / "history.csv").read_bytes(), (other / "history.csv").read_bytes())
        self.assertEqual([path.name for path in states(one)], [path.name for path in states(other)])
        self.assertGreater(len(states(one)), 0)
        for path in states(one):
            self.assert_same_data(path, other / path.name)
        self.assertEqual((one / "snapshots.h5").exists(), (other / "snapshots.h5").exists())
        if (one / "snapshots.h5").exists():
            self.assert_same_data(one / "snapshots.h5", other / "snapshots.h5")
        pictures = sorted(path.relative_to(one) for path in one.glob("fields/*.vtu"))
        self.assertEqual(pictures, sorted(path.relative_to(other) for path in other.glob("fields/*.vtu")))
        for path in pictures:
            self.assertEqual((one / path).read_bytes(), (other / path).read_bytes(), path)


class SameBits(RankRuns):
    """history.csv, snapshots, pictures and the end state do not depend on the number of ranks."""

    def check(self, name, ranks=(1, 2, 3, 4)):
        one, _ = self.run_on(None, SCENES[name], "none")
        with open(one / "history.csv") as file:
            rows = list(csv.DictReader(file))
        self.assertGreater(len(rows), 2)
        self.assertGreater(max(float(row["coordination"]) for row in rows), 0)
        for number in ranks:
            several, _ = self.run_on(number, SCENES[name], str(number))
            self.assert_same(one, several)

    def test_two_disks(self):
        self.check("two_disks")  # and ranks without a body
        said = (self.base / "4" / "run.log").read_text()
        self.assertRegex(said, r"warning +2 of 4 ranks have no body")

    def test_thirty(self):
        self.check("thirty")
        # Every rank has the points of its own bodies alone.
        said = (self.base / "3" / "run.log").read_text()
        total = int(re.search(r"material points +(\d+)", said).group(1))
        fewest, most = (int(number) for number in re.search(r"points of a rank +(\d+) to (\d+)", said).groups())
        self.assertGreater(fewest, 0.2 * total)
        self.assertLess(most, 0.45 * total)
        self.assertLessEqual(fewest + 2 * most, 1.2 * total)

    def test_friction(self):
        self.check("friction")

    def check_adhesion(self, name):
        self.check(name, (1, 2))
        without, _ = self.run_on(2, SCENES[name], "without", ["Contact/Adhesion=0"])
        self.assertNotEqual((without / "history.csv").read_bytes(), (self.base / "2" / "history.csv").read_bytes())

    def test_adhesion(self):
        self.check_adhesion("adhesion")

    def test_plastic(self):
        self.check("plastic", (2, 3))

    def test_pushed(self):
        self.check("pushed", (2, 3))

    def test_explicit(self):
        self.check("explicit", (2, 3))

    def test_quasi_static(self):
        self.check("quasi_static", (2, 3))
        # If this made no difference, what agrees would show nothing.
        other, _ = self.run_on(2, SCENES["quasi_static"], "other", ["Packing/Seed=7"])
        self.assertNotEqual((other / "history.csv").read_bytes(), (self.base / "2" / "history.csv").read_bytes())

    def test_biaxial(self):
        self.check("biaxial")

    def test_periodic(self):
        self.check("periodic")

    def test_rays(self):
        self.check("rays", (2, 3))

    def test_cell_of_balls(self):
        self.check("cell_of_balls", (2, 3))
        self.assertRegex((self.base / "3" / "run.log").read_text(), r"bodies of a rank +1 to 2")

    def test_moving_balls(self):
        self.check("moving_balls", (2,))

    def test_explicit_balls(self):
        self.check("explicit_balls", (2,))

    def test_plastic_balls(self):
        self.check("plastic_balls", (2,))

    def test_thesis_method(self):
        self.check("thesis_method")

    def test_bonded(self):
        self.check("bonded")

    def test_bonded_friction(self):
        self.check("bonded_friction", (2, 3))

    def test_bonded_pressed(self):
        self.check("bonded_pressed", (2, 3))
        with open(self.base / "2" / "history.csv") as file:
            lengths = [float(row["dt_s"]) for row in csv.DictReader(file)][1:]
        self.assertLess(max(lengths), 2e-6)  # 3e-6 was asked for

    def test_bonded_adhesion(self):
        self.check_adhesion("bonded_adhesion")

    def test_bonded_grain(self):
        self.check("bonded_grain")

    def test_bonded_cell(self):
        self.check("bonded_cell", (2,))


class Moves(RankRuns):
    """Bodies move to other ranks where work is uneven, which leaves no trace in results."""

    def scene(self, of_column):
        """Eight by eight grains, pressed from above; those of some columns have a law that takes longer."""
        table = self.base / "grains.csv"
        step = 1.25e-3
        grains = [f"{(i + 0.5) * step},{(j + 0.5) * step},{0.495 * step},{of_column(i)}" for i in range(8) for j in range(8)]
        table.write_text("\n".join(["x_m,y_m,radius_m,material", *grains]) + "\n")
        return ["gallery/thirty_grains_mpm.prm", "Mesh/Cell size=4e-4", "Packing/Number=0", f"Packing/File={table}",
                "Packing/Upper=1, 1", "Materials/Names=gel, clay", "Materials/clay/Law=j2_plastic", "Materials/clay/Density=990",
                "Walls/top/Point=0, 10e-3", "Walls/top/Velocity=5", "Output/History every=5", "Stop/End time=2.5e-4"]

    def test_uneven(self):
        scene = self.scene(lambda column: "clay" if column < 3 else "gel")
        one, _ = self.run_on(None, scene, "none")
        said = None
        # What ranks measure depends on what else a machine does; bits must not.
        for turn in range(3):
            several, _ = self.run_on(2, scene, f"2-{turn}")
            self.assert_same(one, several)
            found = re.search(r"after step (\d+) (\d+) bodies have moved to other ranks, .* had ([\d.]+) of the mean work, "
                              r"and is to have ([\d.]+)", (several / "run.log").read_text())
            said = found or said
            if found and float(found.group(3)) > 1.1 * float(found.group(4)):
                break
        self.assertIsNotNone(said, (several / "run.log").read_text())
        self.assertGreater(int(said.group(2)), 0)
        self.assertLess(int(said.group(2)), 40)
        self.assertGreater(float(said.group(3)), 1.1 * float(said.group(4)))
        self.assertNotIn("have moved", (one / "run.log").read_text())


class Restarts(RankRuns):
    """A checkpoint knows nothing of ranks: 4, then 3, then one process give what one process gives three times."""

    def check(self, name, ends):
        folders = {}
        for way in ((None, None, None), (4, 3, None)):
            for ranks, end in zip(way, ends):
                more = ["--restart"] if end != ends[0] else []
                folders[way], _ = self.run_on(ranks, SCENES[name], "way" + str(way[0]), [f"Stop/End time={end}"], more)
        self.assert_same(*folders.values())

    def test_friction(self):
        self.check("friction", ("3e-5", "4e-5", "5e-5"))

    def test_plastic(self):
        self.check("plastic", ("2e-5", "3e-5", "4e-5"))

    def test_rays_hopper(self):
        self.check("rays_hopper", ("0.024", "0.03", "0.036"))
        with open(self.base / "way4" / "history.csv") as file:
            self.assertGreater(max(abs(float(row["left_plate_force_x_N_per_m"])) for row in csv.DictReader(file)), 0)

    def test_bonded(self):
        self.check("bonded", ("5e-6", "1e-5", "2e-5"))


class Ends(RankRuns):
    """However a run on several ranks ends, it ends, says so once, and leaves what can be gone on from."""

    def start(self, ranks, settings, seconds=1., scene=SCENES["two_disks"]):
        folder = self.base / "run"
        process = subprocess.Popen(launch(ranks, words(scene, folder, settings)), stdout=subprocess.PIPE,
                                   stderr=subprocess.PIPE, text=True, env=ENVIRONMENT)
        self.addCleanup(lambda: process.poll() is None and process.kill())
        wait_for_rows(folder, 1, process)
        time.sleep(seconds)
        self.assertIsNone(process.poll())
        return folder, process

    def test_refused(self):
        _, done = self.run_on(3, SCENES["two_disks"], "wrong", ["Contact/Friction=-1"], expect=2)
        self.assertEqual(done.stderr.count("softgrain: error: "), 1, done)

    def test_lock(self):
        folder, process = self.start(2, MANY_STEPS)
        holder = self.first_rank(self.ranks_of(process, 2))
        _, done = self.run_on(2, SCENES["two_disks"], "run", MANY_STEPS, expect=2)
        self.assertEqual(done.stderr.count(f"is in use by another run (process {holder}"), 1, done)
        process.send_signal(signal.SIGUSR1)  # which mpirun hands to all ranks
        process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3)
        self.assertEqual(status(folder), "interrupted")
        self.run_on(2, SCENES["two_disks"], "run", more=["--restart"])
        self.assertFalse((folder / "run.lock").exists())

    def test_within_a_step(self):
        folder, process = self.start(2, LONG_STEPS["held"], scene=whole_runs.SCENES["held"])
        process.send_signal(signal.SIGUSR1)
        said, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, error)
        self.assertEqual(said.count("the state is saved in"), 1, said)
        self.assertEqual(len(states(folder)), 1)

    def test_within_a_solve(self):
        folder, process = self.start(2, LONG_STEPS["bpm"], scene=whole_runs.SCENES["bpm"])
        process.send_signal(signal.SIGUSR1)
        _, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 3, error)
        self.assertEqual(len(states(folder)), 1)

    def ranks_of(self, process, number):
        """Process ids of the ranks that mpirun has started."""
        lines = subprocess.run(["ps", "-o", "pid=,args=", "--ppid", str(process.pid)], capture_output=True, text=True,
                               check=True).stdout.splitlines()
        found = [int(line.split()[0]) for line in lines if str(PROGRAM) in line]
        self.assertEqual(len(found), number)
        return found

    def test_killed(self):
        folder, process = self.start(3, [*MANY_STEPS, "Output/Checkpoint every=1e-3"])
        os.kill(self.ranks_of(process, 3)[1], signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.assertEqual(status(folder), "running")  # nobody was left to say more
        self.run_on(2, SCENES["two_disks"], "run", MANY_STEPS[1:], ["--restart"])

    def wait_for_another(self, folder):
        """Until there is a checkpoint that is not there yet."""
        known, deadline = states(folder), time.monotonic() + 60
        while not set(states(folder)) - set(known):
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.005)

    def first_rank(self, ranks):
        """The process id of the one among these that MPI calls 0."""
        found = [rank for rank in ranks
                 if b"OMPI_COMM_WORLD_RANK=0" in pathlib.Path(f"/proc/{rank}/environ").read_bytes().split(b"\0")]
        self.assertEqual(len(found), 1)
        return found[0]

    def test_killed_bonded(self):
        settings = ["Contact/Friction=0.3", "Walls/top/Velocity=5", "Stop/End time=2e-6"]
        folder, process = self.start(3, [*settings, "Time/Time step=1e-9", "Output/Checkpoint every=1e-3"], scene=BONDED)
        self.wait_for_another(folder)
        os.kill(self.ranks_of(process, 3)[1], signal.SIGKILL)
        process.communicate(timeout=60)
        self.assertNotEqual(process.returncode, 0)
        self.run_on(2, BONDED, "run", [*settings, "Time/Time step=1e-7"], ["--restart"])
        self.assertEqual(status(folder), "completed")

    def test_full_disk(self):
        folder, process = self.start(2, [*MANY_STEPS, "Output/Checkpoint every=1e-3"])
        limit = max(path.stat().st_size for path in states(folder)) // 2
        ranks = self.ranks_of(process, 2)
        # Another rank than the first writes nothing, so that it needs no room.
        rest = next(rank for rank in ranks if rank != self.first_rank(ranks))
        resource.prlimit(rest, resource.RLIMIT_FSIZE, (0, 0))
        self.wait_for_another(folder)
        resource.prlimit(self.first_rank(ranks), resource.RLIMIT_FSIZE, (limit, limit))
        _, error = process.communicate(timeout=60)
        self.assertEqual(process.returncode, 1, error)
        self.assertEqual(error.count("softgrain: error: "), 1, error)
        self.assertIn("File too large", error)
        self.assertIn(f"the newest checkpoint is {states(folder)[-1]}", error)
        self.assertEqual(status(folder), "failed")
        self.run_on(2, SCENES["two_disks"], "run", MANY_STEPS[1:], ["--restart"])


whole_runs.main()
