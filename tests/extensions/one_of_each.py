# SPDX-License-Identifier: LGPL-2.1-or-later
"""One new member of every family of replaceable parts, each in one file outside of the tree, and in a library that
the parameter file names. What they do is known beforehand. CONTRIBUTING's table names the same families."""
import csv
import math
import pathlib
import re
import subprocess
import sys

PROGRAM, SOURCE, WORK, MODULES = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), sys.argv[4].split(",")
LIBRARIES = ", ".join(MODULES)

SCENE = """
set Additional shared libraries = {libraries}
subsection Mesh
  set Lower     = -0.5, -0.5
  set Upper     = 2.5, 2.5
  set Cell size = 0.1
end
subsection Materials
  set Names = gel
end
"""

ELLIPSE = SCENE + """
subsection Time
  set Time step = 1e-3
end
subsection Bodies
  set Names = egg
  subsection egg
    set Shape     = oval
    set Center    = 1, 0.5
    set Half axes = 0.8, 0.5
  end
end
subsection Walls
  set Names = bottom, top, left, right
  subsection top
    set Point = 0, 1
    set Drive = track
    set Travel = 0.02*sin(200*t)^2
  end
  subsection right
    set Point = 2, 0
  end
end
subsection Stop
  set Steps = 7
end
"""

BAR = """
set Additional shared libraries = {libraries}
subsection Mesh
  set Lower     = -0.1, -0.1
  set Upper     = 1.1, 0.25
  set Cell size = 0.05
end
subsection Materials
  set Names = gel
  subsection gel
    set Law     = linear_elastic
    set Density = 1000
    subsection Linear elastic
      set Young's modulus = 1e5
      set Poisson's ratio = 0
    end
  end
end
subsection Material points
  set Shape function = linear
end
subsection Bodies
  set Names = bar
  subsection bar
    set Shape    = rectangle
    set Center   = 0.5, 0.075
    set Size     = 1, 0.15
    set Velocity = 1e-3*cos(pi*x); 0
  end
end
subsection Newton
  set Residual tolerance = 1e-12
end
"""

LATTICE = SCENE + """
subsection Packing
  set Method         = square_lattice
  set Disks per side = 2
  set Spacing        = 0.5
end
subsection Walls
  set Names = bottom
end
subsection Loads
  set Gravity = 0, -10
end
subsection Contact
  set Geometry            = none
  set Largest penetration = 100 # they fall through the bottom, and shall
end
subsection Time
  set Time step = 1e-2
end
subsection Stop
  set End time = 0.2
end
subsection Output
  set Snapshots every = 0.1
  set Measures        = number_of_bodies
end
"""

AGGREGATE = """
set Model = bpm
set Additional shared libraries = {libraries}
subsection Materials
  set Names = m
  subsection m
    set Law     = falling
    set Density = 1
    subsection Falling
      set Largest force = 1
    end
  end
end
subsection Bodies
  set Names = grain
  subsection grain
    set Shape  = disk
    set Radius = 6
  end
end
subsection Primaries
  set Smallest diameter = 1.6
  set Largest diameter  = 2.6
end
subsection Stop
  set Steps = 5
end
"""

STICKING = """
set Model = bpm
set Additional shared libraries = {libraries}
subsection Materials
  set Names = m
  subsection m
    set Density = 1
    subsection Power law
      set Force at contact = 0
    end
  end
end
subsection Bodies
  set Names = disk
  subsection disk
    set Center   = 0, 0.5
    set Radius   = 0.5
    set Velocity = 0; 1
  end
end
subsection Primaries
  set Smallest diameter = 1
  set Largest diameter  = 1
  set Number per body   = 1
end
subsection Walls
  set Names = bottom
end
subsection Contact
  set Law          = fading
  set Adhesion     = 2
  set Fading range = 0.1
end
subsection Time
  set Time step = 1e-4
end
subsection Stop
  set End time = 0.2
end
"""

PADDLE = """
subsection Obstacles
  set Names = paddle
  subsection paddle
    set Points            = 0, 0; 1, 0
    set Pivot             = 0, 0
    set Drive             = torque
    set Moment of inertia = {inertia}
    set Torque            = 10*{inertia}
  end
end
subsection Time
  set Time step = 1e-3
end
subsection Stop
  set End time = 0.15
end
"""

PUSHED = {
    "mpm": SCENE.replace("0.1\nend", "0.05\nend") + """
subsection Bodies
  set Names = disk
  subsection disk
    set Radius = 0.2
    set Center = 0.6, 0.22
  end
end
""",
    "bpm": STICKING[:STICKING.index("subsection Walls")].replace("Center   = 0, 0.5", "Center   = 0.6, 0.22").replace(
        "Radius   = 0.5", "Radius   = 0.2").replace("0; 1", "0; 0").replace("= 1\n  set Largest diameter  = 1\n", "= 0.4\n  set Largest diameter  = 0.4\n")}

FLYING = {
    "mpm": SCENE + """
subsection Bodies
  set Names = disk
  subsection disk
    set Radius   = 0.3
    set Center   = 0, 0.5
    set Velocity = 2; 0
  end
end
subsection Time
  set Time step = 1e-2
  set Theta     = 0.5
end
subsection Newton
  set Residual tolerance = 1e-12
end
""",
    "bpm": STICKING.replace("set Velocity = 0; 1", "set Velocity = 2; 0").replace("set Time step = 1e-4", "set Time step = 1e-2")}


def run(name, text, *changes):
    """Columns of the history of a run, by name."""
    WORK.mkdir(parents=True, exist_ok=True)
    file, folder = WORK / f"{name}.prm", WORK / name
    file.write_text(text.format(libraries=LIBRARIES))
    words = [PROGRAM, "run", str(file), "--output", str(folder), "--overwrite"]
    for change in changes:
        words += ["--set", change]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, f"{name}: {done.stdout}{done.stderr}"
    return columns_of(folder), folder


def columns_of(folder):
    with open(folder / "history.csv") as rows:
        table = list(csv.DictReader(rows))
    return {key: [float(row[key] or "nan") for row in table] for key in table[0]}


def go_on(name, folder, *changes):
    """Columns of the history of a run that goes on from its checkpoint."""
    words = [PROGRAM, "run", str(WORK / f"{name}.prm"), "--output", str(folder), "--restart"]
    for change in changes:
        words += ["--set", change]
    done = subprocess.run(words, capture_output=True, text=True)
    assert done.returncode == 0, f"{name}, going on: {done.stdout}{done.stderr}"
    return columns_of(folder)


def same(a, b):
    return all(x == y or (math.isnan(x) and math.isnan(y)) for key in a for x, y in zip(a[key], b[key], strict=True))


def check_ellipse():
    own, _ = run("own", ELLIPSE, "Time/Scheme=backward_euler", "Material points/Shape function=hats")
    dense, _ = run("dense", ELLIPSE, "Time/Scheme=moreau_jean", "Time/Theta=1", "Material points/Shape function=linear",
                   "Linear solver/Type=dense")
    known, _ = run("known", ELLIPSE, "Time/Scheme=moreau_jean", "Time/Theta=1", "Material points/Shape function=linear")
    assert own["step"][-1] == 7, "stop condition: the run has " + str(own["step"][-1]) + " steps instead of 7"
    assert abs(own["packing_fraction"][0] - math.pi * 0.8 * 0.5 / 2) < 1e-3, "shape: the ellipse has another area"
    for time, place in zip(own["time_s"], own["top_position_m"]):
        assert abs(place - (1 - 0.02 * math.sin(200 * time) ** 2)) < 1e-9, f"wall drive: the wall is at {place}"
    assert max(own["top_force_N_per_m"]) > 0, "the ellipse has not been touched"
    for force, other in zip(dense["top_force_N_per_m"], known["top_force_N_per_m"]):
        assert abs(force - other) < 1e-8 * max(known["top_force_N_per_m"]), f"linear solver: {force}, not {other}"
    assert not same(dense, known), "linear solver: to the last digit the numbers of another one"
    assert same(own, known), "time scheme or shape function: not the numbers of the same ones under other names"


def alpha_oscillator(omega, step, n):
    """Displacement and velocity of one mass that sets out from rest at 0 with velocity 1, by generalised-alpha."""
    radius = 0.5
    alpha_m, alpha_f = (2 * radius - 1) / (radius + 1), radius / (radius + 1)
    gamma, beta = 0.5 - alpha_m + alpha_f, (1 - alpha_m + alpha_f) ** 2 / 4
    x, v, a = 0.0, 1.0, 0.0
    yield x, v
    for _ in range(n):
        known = x + step * v + step**2 * (0.5 - beta) * a
        end = -(alpha_m * a + omega**2 * ((1 - alpha_f) * known + alpha_f * x)) / (1 - alpha_m + omega**2 * (1 - alpha_f) * beta * step**2)
        x, v, a = known + step**2 * beta * end, v + step * ((1 - gamma) * a + gamma * end), end
        yield x, v


def check_alpha():
    """A bar in its first mode is one oscillator, whose frequency with hats and lumped masses is known. Generalised-alpha, which
    is no choice of terms, gives step by step what its recursion says, has order 2, and its books are right."""
    cell, speed = 0.05, 10
    omega = 2 * speed / cell * math.sin(math.pi * cell / 2)
    off = []
    for n in (40, 80, 160):
        step = (2 * math.pi + 0.6) / omega / n
        history, _ = run(f"alpha_{n}", BAR, "Time/Scheme=generalised_alpha", f"Time/Time step={step!r}", f"Stop/Steps={n}")
        kinetic, elastic = history["kinetic_energy_J_per_m"], history["elastic_energy_J_per_m"]
        books = [k + e + lost for k, e, lost in zip(kinetic, elastic, history["scheme_damping_J_per_m"])]
        assert len(kinetic) == n + 1, f"generalised-alpha: {len(kinetic) - 1} steps instead of {n}"
        for k, e, sum_, (x, v) in zip(kinetic, elastic, books, alpha_oscillator(omega, step, n)):
            assert abs(k / kinetic[0] - v**2) < 1e-8, f"generalised-alpha: kinetic energy {k / kinetic[0]}, not {v**2}"
            assert abs(e / kinetic[0] - (omega * x) ** 2) < 1e-8, f"generalised-alpha: elastic energy {e / kinetic[0]}, not {(omega * x)**2}"
            assert abs(sum_ / kinetic[0] - 1) < 1e-8, f"generalised-alpha: its books are off by {sum_ / kinetic[0] - 1}"
        off.append(abs(kinetic[-1] / kinetic[0] - math.cos(0.6) ** 2))
    orders = [math.log2(coarse / fine) for coarse, fine in zip(off, off[1:])]
    assert all(abs(order - 2) < 0.07 for order in orders), f"generalised-alpha: orders {orders}, not 2"


def check_going_on():
    """A run may go on with another motion of its walls, whatever drives them."""
    _, folder = run("going_on", ELLIPSE)
    last = go_on("going_on", folder, "Stop/Steps=9", "Walls/top/Travel=0.01*sin(100*t)^2")["step"][-1]
    assert last == 9, f"going on: ends at step {last}"


def check_lattice():
    history, folder = run("lattice", LATTICE)
    mass = 4 * math.pi * (0.45 * 0.5) ** 2 * 1000
    for time, kinetic in zip(history["time_s"], history["kinetic_energy_J_per_m"]):
        expected = 0.5 * mass * (10 * time) ** 2
        assert abs(kinetic - expected) < 1e-5 * (1e-3 + expected), f"contact geometry, packing: {kinetic}, not {expected}"
    with open(folder / "measures.csv") as rows:
        counts = {float(row["number_of_bodies"]) for row in csv.DictReader(rows)}
    assert counts == {4.0}, f"measure: {counts} bodies"


def check_aggregate():
    history, _ = run("aggregate", AGGREGATE)
    assert history["elastic_energy_J_per_m"][0] < -1, "attraction: it has stored nothing"
    kinetic = max(history["kinetic_energy_J_per_m"])
    assert kinetic < 1e-3 * -history["elastic_energy_J_per_m"][0], "attraction: the aggregate is not at rest"


def check_sticking():
    history, _ = run("sticking", STICKING)
    lost = history["kinetic_energy_J_per_m"][0] - history["kinetic_energy_J_per_m"][-1]
    work = history["adhesion_work_J_per_m"][-1]
    # A step at this speed takes the force of its start, up to 1e-3 too much.
    assert abs(lost - 0.5 * 2 * 0.1) < 2e-3 * lost, f"contact law: the disk has lost {lost} J/m, not 0.1"
    assert abs(lost + work) < 1e-9 * lost, f"contact law: its work is {work} J/m, what the disk has lost {lost} J/m"


def paddle(inertia):
    return PADDLE.replace("{inertia}", repr(inertia))


def check_paddle():
    """A paddle turns under a torque T. Alone, its angle is T t^2 / (2 I). When it meets a disk, T t is what the paddle and the
    disk have of angular momentum, and that of the paddle is, step by step, what its torque and the disk have given it."""
    for model, text in PUSHED.items():
        alone, _ = run(f"paddle_alone_{model}", text + paddle(1.0), "Stop/End time=0.05")
        for time, angle in zip(alone["time_s"], alone["paddle_angle_rad"]):
            assert abs(angle - 5 * time**2) < 1e-12, f"obstacle drive, {model}: alone it has turned by {angle}, not {5 * time**2}"
        density = 1 if model == "bpm" else 1000
        mass = math.pi * 0.2**2 * density
        inertia = 4 * 0.6**2 * mass
        torque = 10 * inertia
        history, _ = run(f"paddle_{model}", text + paddle(inertia))
        given, met = 0.0, False
        rows = list(zip(history["time_s"], history["paddle_angle_rad"], history["paddle_torque_N"]))
        for (time, angle, _), (then, next_angle, felt) in zip(rows, rows[1:]):
            step = then - time
            speed = (next_angle - angle) / step - 0.5 * step * torque / inertia
            assert abs(inertia * speed - given) < 1e-8 * torque, f"obstacle drive, {model}: {inertia * speed} and not {given} at {time} s"
            given += step * (torque + felt)
            met = met or felt < 0
        assert met, f"obstacle drive, {model}: the paddle has met nothing"
        _, folder = run(f"paddle_cut_{model}", text + paddle(inertia), "Stop/Steps=90")
        cut = go_on(f"paddle_cut_{model}", folder, "Stop/Steps=0")
        assert same(cut, history), f"obstacle drive, {model}: a run that goes on from its checkpoint is another"
        # The disk goes about as fast as the place that pushes it, at right angles to the paddle.
        of_disk = math.sqrt(2 * mass * history["kinetic_energy_J_per_m"][-1]) * 0.6
        assert abs(given + of_disk - torque * rows[-1][0]) < 0.02 * torque * rows[-1][0], (
            f"obstacle drive, {model}: paddle and disk have {given} and {of_disk}, the torque has given {torque * rows[-1][0]}")
    words = [PROGRAM, "check", str(WORK / "paddle_mpm.prm"), "--set", "Time/Scheme=quasi_static"]
    said = subprocess.run(words, capture_output=True, text=True)
    assert said.returncode == 2 and "'Obstacles/paddle/Drive' is not allowed" in said.stderr, f"obstacle drive: {said.returncode}, {said.stderr}"


def check_flying():
    for model, text in FLYING.items():
        history, _ = run(f"flying_{model}", text, "Loads/Quadratic drag=3", "Stop/End time=0.5")
        mass = 2 * history["kinetic_energy_J_per_m"][0] / 2 ** 2
        for time, kinetic, work in zip(history["time_s"], history["kinetic_energy_J_per_m"], history["quadratic_drag_work_J_per_m"]):
            expected = 0.5 * mass * (2 / (1 + 3 * 2 * time)) ** 2
            assert abs(kinetic - expected) < 1e-3 * expected, f"load, {model}: {kinetic}, not {expected}"
            first = history["kinetic_energy_J_per_m"][0]
            change = kinetic - first
            assert abs(work - change) < 1e-9 * first, f"load, {model}: its work is {work}, not {change}"


def check_table():
    """CONTRIBUTING's table has a row for every module here, at most four files each, and the folders exist."""
    page = (SOURCE / "CONTRIBUTING.md").read_text()
    rows = re.findall(r"^\| ([^|]+) \| ([^|]+) \| ([^|]+) \| `tests/extensions/modules/(\w+)\.cc` \|$", page, re.M)
    modules = {path.stem for path in (SOURCE / "tests/extensions/modules").glob("*.cc")}
    assert {row[3] for row in rows} == modules, f"CONTRIBUTING names {sorted(row[3] for row in rows)}, not {sorted(modules)}"
    for family, _, files, module in rows:
        places = re.findall(r"`([^`]+)`", files)
        assert 1 <= len(places) <= 4, f"{family}: {len(places)} files"
        for place in places:
            folder = SOURCE / pathlib.Path(place).parent
            assert folder.is_dir(), f"{family}: {folder} does not exist"
        header = re.search(r"#include <(softgrain/[^>]+)>", (SOURCE / f"tests/extensions/modules/{module}.cc").read_text())
        assert header, f"{module}.cc includes nothing of softgrain"


for check in (check_table, check_ellipse, check_alpha, check_going_on, check_lattice, check_aggregate, check_sticking, check_flying, check_paddle):
    check()
    print(check.__name__[6:].replace("_", " "), "as expected")
