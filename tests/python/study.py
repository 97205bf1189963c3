# SPDX-License-Identifier: LGPL-2.1-or-later
"""
`softgrain study`: orders that are known, runs that are used again, go on or fail, what is wrong in a study file, its page.
Arguments: see common.py.
"""

import csv
import json
import math
import os
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

import common
import numpy as np
import softgrain
from softgrain.page import read_data
from softgrain.study_quantities import difference
from softgrain.study_results import Result, fit_order, mark_front
from tool_runs import run

BROWSER = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
BAR = os.path.abspath(os.path.join(common.PYTHON, os.pardir, "parameters/verification/bar_period.prm"))

STUDY = """
set Scene     = {scene}
set Reference = step = 1e-3
subsection Settings
  set Mesh/Cell size = 0.05
  set Stop/End time  = 0.16
  set Output/Number of field outputs = 1
  set Time/Theta     = {theta}
end
subsection Knobs
  set Names = step
  subsection step
    set Parameter = Time/Time step
    set Values    = 8e-3, 4e-3, 2e-3
  end
end
subsection Quantities
  set Names = energy
  subsection energy
    set Column = kinetic_energy
    set At     = 0.032, 0.08, 0.112, 0.16
    set Norm   = rms
  end
end
"""


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def write(name, text):
    with open(name, "w", encoding="utf-8") as file:
        file.write(text)
    return name


def bar(name, theta=0.5, change=lambda text: text):
    return write(name, change(STUDY.format(scene=BAR, theta=theta)))


def table(folder):
    with open(os.path.join(folder, "study.csv"), newline="", encoding="utf-8") as file:
        return list(csv.DictReader(file))


class Unchecked(unittest.TestCase):
    """Only the first point is looked at before all are run: Mistakes are another matter."""

    @classmethod
    def setUpClass(cls):
        cls.usual, softgrain.study.MOST_CHECKS = softgrain.study.MOST_CHECKS, 0.

    @classmethod
    def tearDownClass(cls):
        softgrain.study.MOST_CHECKS = cls.usual


class Orders(Unchecked):
    def test_of_the_time_schemes(self):
        """The middle of the step is of second order, its end of first."""
        for theta, expected, within, scale in ((0.5, 2., 0.1, 1), (1., 1., 0.1, 8)):
            steps = [f"{step / scale:g}" for step in (8e-3, 4e-3, 2e-3, 1e-3)]
            name = bar(f"theta_{theta}.prm", theta, lambda text, steps=steps: text.replace(
                "8e-3, 4e-3, 2e-3", ", ".join(steps[:3])).replace("1e-3", steps[3]))
            code, printed, errors = run("study.py", name, "--no-pictures")
            self.assertEqual((code, errors), (0, ""), printed)
            data = json.loads(text_of(f"output/studies/theta_{theta}/study.json"))
            self.assertEqual([order["knob"] for order in data["orders"]], ["step"])
            self.assertTrue(data["orders"][0]["good"])
            self.assertAlmostEqual(data["orders"][0]["order"], expected, delta=within)
            rows = table(f"output/studies/theta_{theta}")
            self.assertEqual([row["step"] for row in rows], steps)
            self.assertEqual([row["reference"] for row in rows], ["0", "0", "0", "1"])
            self.assertEqual(rows[3]["error_energy"], "")
            # The same errors by means that are not those of the package.
            of_run = {}
            for point in data["points"]:
                with open(os.path.join(f"output/studies/theta_{theta}", point["tasks"][0]["folder"], "history.csv"),
                          newline="", encoding="utf-8") as file:
                    found = {round(float(row["time_s"]), 6): float(row["kinetic_energy_J_per_m"]) for row in csv.DictReader(file)}
                of_run[point["step"]] = [found[t] for t in (0.032, 0.08, 0.112, 0.16)]
            for row in rows[:3]:
                relative = [a / b - 1 for a, b in zip(of_run[row["step"]], of_run[steps[3]])]
                self.assertAlmostEqual(float(row["error_energy"]) / np.sqrt(np.mean(np.square(relative))), 1., delta=1e-4)
                self.assertGreater(float(row["cpu_seconds"]), 0.)
                self.assertEqual(int(float(row["steps"])), round(0.16 / float(row["step"])))

    def test_fit(self):
        """A reference that is not exact changes the slope of the errors, not the order."""
        h = np.array([1., 2., 4., 8.])
        for order in (0.5, 1., 2., 4.):
            self.assertAlmostEqual(fit_order(h, 7 * h**order)[0], order, delta=1e-9)
            self.assertAlmostEqual(fit_order(h, 7 * (h**order - 0.8**order), 0.8)[0], order, delta=1e-6)

    def test_exact_reference(self):
        """Against the formula of the first mode, and against the same as a table."""
        t = np.linspace(0, 0.2, 401)
        write("curve.csv", "t,E\n" + "".join(f"{a!r},{3.75e-5 * math.cos(10 * math.pi * a)**2!r}\n" for a in t.tolist()))
        errors = []
        for kind in ("Formula = 3.75e-5*cos(2*pi*x/0.2)^2", "Curve = curve.csv"):
            name = bar("exact.prm", change=lambda text, kind=kind: text.replace("set Reference = step = 1e-3", "").replace(
                "set At     = 0.032, 0.08, 0.112, 0.16", f"set Between = 0, 0.16\n    set {kind}").replace(
                    "set Reference = ", "# "))
            code, printed, said = run("study.py", name, "--no-pictures")
            self.assertEqual((code, said), (0, ""), printed)
            errors.append([float(row["error_energy"]) for row in table("output/studies/exact")])
            self.assertEqual("[1/" in printed, kind.startswith("Formula"))  # a reference needs no other runs
        np.testing.assert_allclose(*errors, rtol=2e-3)
        self.assertTrue(0.05 > errors[0][0] > errors[0][1] > errors[0][2] > 0, errors)
        data = json.loads(text_of("output/studies/exact/study.json"))
        history = softgrain.open("output/studies/exact/" + data["points"][0]["tasks"][0]["folder"]).history_table
        x = np.linspace(0, 0.16, 201)
        left = np.interp(x, history["time_s"], history["kinetic_energy_J_per_m"]) / 3.75e-5 - np.cos(10 * np.pi * x)**2
        self.assertAlmostEqual(errors[0][0] / np.sqrt(np.mean(left**2)), 1., delta=1e-3)


class Numbers(unittest.TestCase):
    """Norms, averages and the front, by hand."""

    def quantity(self, at=(1., 2.), between=None, norm="max", average="means"):
        from softgrain.formula import Formula
        from softgrain.study_file import Quantity
        return Quantity("q", Formula("y"), Formula("x"), list(at), between, 0., norm, average)

    def test_norms(self):
        found, reference = [[1.1, 1.8]], [[1., 2.]]
        for norm, expected in (("max", 0.1), ("mean", 0.1), ("rms", 0.1)):
            self.assertAlmostEqual(difference(self.quantity(norm=norm), found, reference).error, expected)
        found = [[1.1, 2.6]]
        for norm, expected in (("max", 0.3), ("mean", 0.2), ("rms", np.sqrt(0.05))):
            self.assertAlmostEqual(difference(self.quantity(norm=norm), found, reference).error, expected)
        # In a window differences are relative to the largest value: 0 as a reference value does no harm.
        window = self.quantity((), (0., 1.))
        self.assertAlmostEqual(difference(window, [[0.1, 2.]], [[0., 2.]]).error, 0.05)
        window = self.quantity((), (0., 1.), "of means")
        self.assertAlmostEqual(difference(window, [[0.1, 2.]], [[0., 2.]]).error, 0.05)
        self.assertAlmostEqual(difference(window, [[1., 1.]], [[0., 2.]]).error, 0.)
        self.assertIn("reference is 0", difference(self.quantity(), [[1., 1.]], [[0., 1.]]).note)
        self.assertIn("does not reach x = 2", difference(self.quantity(), [[1., np.nan]], [[1., 1.]]).note)

    def test_averages(self):
        """Errors of opposite signs cancel in a mean, not in the mean error; the scatter is that of one run."""
        found, reference = [[1.1], [0.9], [1.3]], [[1.], [1.], [1.]]
        means = difference(self.quantity((1.,)), found, reference)
        self.assertAlmostEqual(means.error, 0.1)
        self.assertAlmostEqual(means.scatter, 0.2)
        each = difference(self.quantity((1.,), average="errors"), found, reference)
        self.assertAlmostEqual(each.error, np.sqrt((0.01 + 0.01 + 0.09) / 3))

    def test_front(self):
        class Known(Result):
            def cost(self, name):
                return self.records[0]
        from softgrain.study_quantities import Difference
        points = [(1., 0.3), (2., 0.1), (3., 0.099), (4., 0.2), (5., 0.05), (6., np.nan), (np.nan, 0.01), (2., 0.4)]
        results = [Known(None, [None], [cost], {"q": Difference(error)}) for cost, error in points]
        mark_front(results, "q", "cpu_seconds")
        self.assertEqual([one.front["q"] for one in results], [True, True, False, False, True, False, False, False])


class Running(Unchecked):
    def test_used_again(self):
        name = bar("again.prm", change=lambda text: text.replace("0.16\n  set O", "0.032\n  set O").replace("0.032, 0.08, 0.112, 0.16", "0.032"))
        code, printed, _ = run("study.py", name, "--no-pictures")
        self.assertEqual((code, len(re.findall(r"^\[\d/4\] .*: completed", printed, re.M))), (0, 4), printed)
        files = {path: os.stat(path).st_mtime_ns for path, *_ in os.walk("output/studies/again/runs")}
        code, printed, _ = run("study.py", name, "--no-pictures")
        self.assertEqual((code, printed.count("completed, ")), (0, 0), printed)
        self.assertEqual({path: os.stat(path).st_mtime_ns for path, *_ in os.walk("output/studies/again/runs")}, files)
        # Another value: one more run. A folder that was removed: run again.
        write(name, text_of(name).replace("8e-3, 4e-3", "8e-3, 16e-3, 4e-3"))
        self.assertIn("[1/1] step = 16e-3: completed", run("study.py", name, "--no-pictures")[1])
        data = json.loads(text_of("output/studies/again/study.json"))
        shutil.rmtree(os.path.join("output/studies/again", data["points"][0]["tasks"][0]["folder"]))
        code, printed, _ = run("study.py", name, "--no-run", "--no-pictures")
        self.assertIn("not run", printed)
        self.assertIn("[1/1] step = 8e-3: completed", run("study.py", name, "--no-pictures")[1])
        # A file that only looks different asks for the same runs, another scene does not.
        write("scene.prm", "# a comment\n" + text_of(BAR))
        write(name, text_of(name).replace(BAR, "scene.prm"))
        self.assertNotIn("not run", run("study.py", name, "--list")[1])
        write("scene.prm", text_of(BAR).replace("Density = 1000", "Density = 1001"))
        self.assertEqual(run("study.py", name, "--list")[1].count("not run"), 5)

    def test_failed(self):
        """A run that cannot be computed is recorded, and the other is not disturbed."""
        name = bar("failed.prm", change=lambda text: text.replace("set Reference = step = 1e-3\n", "").replace(
            "set Parameter = Time/Time step\n    set Values    = 8e-3, 4e-3, 2e-3", "set Values = 1e-3, -1e3").replace(
                "set Time/Theta", "set Bodies/bar/Velocity = {step}*({step} > 0 ? cos(pi*x) : x); 0\n  set Time/Theta").replace(
                        "    set At     = 0.032, 0.08, 0.112, 0.16\n",
                        "    set Between = 0, 0.1\n    set Formula = 3.75e-5*cos(2*pi*x/0.2)^2\n"))
        code, printed, errors = run("study.py", name)
        self.assertEqual((code, errors), (1, ""), printed)
        rows = table("output/studies/failed")
        self.assertEqual([row["status"] for row in rows], ["completed", "failed"])
        self.assertIn("no step longer than", rows[1]["notes"])
        self.assertEqual([bool(row["error_energy"]) for row in rows], [True, False])
        self.assertLess(float(rows[0]["error_energy"]), 0.05)
        page = text_of("output/studies/failed/study.html")
        warnings = page.partition('<ul class="warnings">')[2].partition("</ul>")[0]
        self.assertIn("no step longer than", warnings)
        self.assertNotIn("[1/", run("study.py", name, "--no-pictures")[1])
        self.assertIn("[1/1] step = -1e3: failed", run("study.py", name, "--retry", "--no-pictures")[1])

    def test_too_long(self):
        name = bar("long.prm", change=lambda text: text.replace("8e-3, 4e-3, 2e-3", "1e-6").replace(
            "set Reference = step = 1e-3", "set Longest run = 1").replace("set Norm   = rms", "set Formula = 3.75e-5"))
        code, printed, errors = run("study.py", name)
        self.assertEqual((code, errors), (1, ""), printed)
        self.assertIn("step = 1e-6: too long, not finished after 1 s", printed)
        self.assertEqual([row["status"] for row in table("output/studies/long")], ["too long"])

    def test_interrupted(self):
        """A study that is told to stop goes on, and its run ends as one that was not disturbed."""
        name = bar("stopped.prm", change=lambda text: text.replace("8e-3, 4e-3, 2e-3", "1e-4").replace("1e-3", "1e-4"))
        words = [sys.executable, os.path.join(common.PYTHON, "study.py"), name, "--no-pictures"]

        def history():
            return next((os.path.join(path, "history.csv") for path, _, names in os.walk("output/studies/stopped")
                         if "history.csv" in names), None)

        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        while process.poll() is None and not (history() and text_of(history()).count("\n") > 50):
            time.sleep(0.01)
        process.send_signal(signal.SIGTERM)
        printed, errors = process.communicate(timeout=100)
        self.assertEqual((process.returncode, errors), (3, "interrupted; the same command goes on\n"), printed)
        self.assertIn("step = 1e-4: interrupted", printed)
        first, record = text_of(history()), os.path.dirname(history()) + ".json"
        self.assertLess(first.count("\n"), 1600)
        before = json.loads(text_of(record))
        done = subprocess.run(words, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""), done.stdout)
        whole = softgrain.open(os.path.dirname(history()))
        self.assertTrue(whole.finished)
        self.assertEqual(list(whole.history_table["step"]), list(range(1601)))
        self.assertTrue(text_of(history()).startswith(first[:first.rindex("\n", 0, -1)]))
        after = json.loads(text_of(record))
        for name in ("cpu_seconds", "wall_seconds"):
            self.assertGreater(after[name], before[name] + 0.1)

    def test_empty_values(self):
        """A setting, a value of a knob and --set can empty a parameter."""
        from softgrain.study import Session
        name = bar("empty.prm", change=lambda text: text.replace("Time/Time step", "Output/Measures").replace(
            "8e-3, 4e-3, 2e-3", '"", packing').replace("step = 1e-3", 'step = ""').replace(
                "set Time/Theta     = 0.5", "set Contact/Friction of pairs ="))
        session = Session(name, "nowhere", {"Packing/Save to": ""})
        self.assertEqual([[task.changes[name] for name in ("Output/Measures", "Contact/Friction of pairs", "Packing/Save to")]
                          for task in session.tasks], [["", "", ""], ["packing", "", ""]])
        self.assertEqual(run("study.py", name, "--list", "--set", "Packing/Save to=")[0], 0)

    def test_which_points(self):
        name = bar("which.prm", change=lambda text: text.replace("set Names = step", "set Names = step, cell").replace(
            "  set Mesh/Cell size = 0.05\n", "").replace("subsection Knobs", "subsection Knobs\n  subsection cell\n"
            "    set Parameter = Mesh/Cell size\n    set Values = 0.1, 0.05\n    set Base = 0.05\n  end").replace(
                "set Reference = step = 1e-3", "set Reference = finest"))
        for combinations, expected in (("all", 6), ("one at a time", 4)):
            text = text_of(name)
            write("those.prm", text.replace("set Reference", f"set Combinations = {combinations}\nset Reference"))
            code, printed, errors = run("study.py", "those.prm", "--list")
            found = re.findall(r"runs/step=(\S+?)_cell=(\S+)-\w{8}", printed)
            # The reference, the finest of both, is no point of its own where all are combined.
            self.assertEqual((code, len(found)), (0, expected + (combinations != "all" and ("2e-3", "0.05") not in found)), errors)
            self.assertEqual(len(set(found)), len(found))
            self.assertIn(("2e-3", "0.05"), found)
        self.assertFalse(os.path.exists("output/studies/those"))


class Shipped(unittest.TestCase):
    def test_each_can_be_read(self):
        """The files of parameters/studies, and what they set is known to the program."""
        from softgrain.study import Session, check_points
        folder = os.path.join(os.path.dirname(BAR), os.pardir, "studies")
        names = sorted(os.listdir(folder))
        self.assertGreater(len(names), 5)
        for name in names:
            session = Session(os.path.join(folder, name), "nowhere")
            self.assertGreater(len(session.points), 5, name)
            if "thirty" not in name:  # they take longer to build; their parameters are those of the others
                check_points(session.study, session.jobs[:1], session.program)
            text = text_of(os.path.join(folder, name))
            self.assertRegex(text, r"^# [\s\S]*Takes", name)


class Mistakes(unittest.TestCase):
    def test_each_is_one_line(self):
        for old, new, said in (
                ("set Scene     = " + BAR, "set Scene = nothing.prm", ":2: 'Scene' = 'nothing.prm' is not allowed: there is no file"),
                ("set Reference = step = 1e-3", "", "'Quantities/energy' has neither 'Formula' nor 'Curve', so that 'Reference'"),
                ("step = 1e-3", "stp = 1e-3", ":3: 'Reference' = 'stp = 1e-3' is not allowed: it must be 'finest' or a value"),
                ("set Names = step", "set Names = step, cell", "'Knobs/cell/Values' is missing"),
                ("8e-3, 4e-3", "8e-3, 8e-3", "'Knobs/step/Values' = '8e-3, 8e-3, 2e-3' is not allowed: it must be different"),
                ("set Parameter = Time/Time step", "", "'Knobs/step' changes nothing: it needs 'Parameter'"),
                ("Time/Time step", "Time/Time stp", ":13: unknown parameter 'Time/Time stp'"),
                ("= 0.05", "= {cell/2}", ":5: 'Settings/Mesh/Cell size' = '{cell/2}' is not allowed: there is no knob 'cell'"),
                ("= 0.05", "= many", ":5: 'Mesh/Cell size' = 'many' is not allowed"),
                ("set Time/Theta     = 0.5", "set Time/Time step = 1", "is not allowed: Settings sets it, too"),
                ("set Norm   = rms", "set Norm = least", "'Quantities/energy/Norm' = 'least' is not allowed: it must be one of max"),
                ("set Norm   = rms", "set Norm = of means", "the mean of a window needs 'Between'"),
                ("set Norm   = rms", "set Nrm = rms", "unknown parameter 'Quantities/energy/Nrm' (did you mean "),
                ("set At     = 0.032, 0.08, 0.112, 0.16", "", "needs either 'At' or 'Between'"),
                ("set At     = 0.032, 0.08, 0.112, 0.16", "set Between = 2, 1", "it must be two numbers, the larger last"),
                ("kinetic_energy", "__import__('os')", "is not allowed: "),
                ("kinetic_energy", "kinetic_enrgy", "there is no column 'kinetic_enrgy'"),
                ("set Norm   = rms", "set Formula = 1 + z", "there is no 'z'; there are step, x"),
                ("set Norm   = rms", "set Curve = " + BAR, "is not allowed: "),
                ("subsection Settings", "subsection Setings", "unknown section 'Setings'"),
                ("set Reference", "set Longest run = -1\nset Reference", "'Longest run' = '-1' is not allowed: it must be seconds"),
                ("end\n", "", "has no 'end'")):
            self.assertIn(old, STUDY.format(scene=BAR, theta=0.5), old)
            name = bar("wrong.prm", change=lambda text, old=old, new=new: text.replace(old, new))
            code, printed, errors = run("study.py", name)
            self.assertEqual((code, len(errors.splitlines())), (2, 1), (new, printed, errors))
            self.assertRegex(errors, r"^study: wrong\.prm", new)
            self.assertIn(said, errors)
        for words, said in ((["nothing.prm"], "there is no file 'nothing.prm'"), ([bar("a.prm"), "--jobs", "0"], "--jobs 0"),
                            ([bar("a.prm"), "--set", "Time"], "--set Time: it must be PATH=VALUE")):
            code, _, errors = run("study.py", *words)
            self.assertEqual((code, len(errors.splitlines())), (2, 1), errors)
            self.assertIn(said, errors)


class PageOfStudy(Unchecked):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        name = bar("page.prm", change=lambda text: text.replace("set Names = step", "set Names = step, lift").replace(
            "    set Values    = 8e-3, 4e-3, 2e-3\n  end",
            "    set Values = 8e-3, 4e-3\n  end\n  subsection lift\n    set Values = 0, 0.02\n    set Average = true\n  end").replace(
                "set Mesh/Cell size", "set Mesh/Lower = -0.1, {-0.1 - lift}\n  set Mesh/Cell size").replace("1e-3", "2e-3"))
        code, printed, errors = run("study.py", name, "--jobs", "2")
        assert (code, errors) == (0, ""), (printed, errors)
        cls.text = text_of("output/studies/page/study.html")
        cls.data, cls.rows = read_data(cls.text), table("output/studies/page")

    def test_it_shows_the_table(self):
        chart = next(one for one in self.data["charts"] if "traces" in one and len(one["traces"]) > 1)
        shown = [(x, y) for trace in chart["traces"] if trace["mode"] != "lines" for x, y in zip(trace["x"], trace["y"])]
        written = [(float(row["cpu_seconds"]), float(row["error_energy"])) for row in self.rows if row["error_energy"]]
        np.testing.assert_allclose(sorted(shown), sorted(written), rtol=1e-4)
        self.assertEqual([row["runs"] for row in self.rows], ["2", "2", "2"])
        self.assertTrue(all(float(row["scatter_energy"]) >= 0 for row in self.rows[:2]))
        curves = [chart for chart in self.data["charts"] if "series" in chart]
        self.assertEqual([len(chart["series"]) for chart in curves], [3])
        for words in ("step = 8e-3", "Error against cost", "Curves", "Pictures", "Parameters", "reference"):
            self.assertIn(words, self.text)
        self.assertGreaterEqual(self.text.count('src="data:image/png'), 3)
        self.assertGreater(os.stat("output/studies/page/study.png").st_size, 10000)

    def test_without_states(self):
        """Runs that wrote no states are shown all the same."""
        name = bar("bare.prm", change=lambda text: text.replace("field outputs = 1", "field outputs = 0").replace("1e-3", "2e-3").replace(
            "8e-3, 4e-3", "8e-3"))
        self.assertEqual(run("study.py", name)[0], 0)
        data = read_data(text_of("output/studies/bare/study.html"))
        curves = [chart for chart in data["charts"] if "series" in chart]
        self.assertEqual([len(chart["series"]) for chart in curves], [2])
        self.assertGreater(len(data["tables"]["0/energy"]["energy"]), 10)

    @unittest.skipUnless(BROWSER, "no Chromium is there to open the page")
    def test_a_browser_shows_it(self):
        done = subprocess.run(
            [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1400,900", "--dump-dom",
             "--virtual-time-budget=10000", "--enable-logging=stderr", "--v=0",
             f"--user-data-dir={os.path.join(common.WORK, 'profile')}",
             "file://" + os.path.abspath("output/studies/page/study.html")],
            capture_output=True, text=True, timeout=240, check=True)
        self.assertEqual([line for line in done.stderr.splitlines() if ":CONSOLE" in line], [])
        self.assertIn(f'data-drawn="{len(self.data["charts"])}"', done.stdout)
        self.assertRegex(done.stdout, r'<div id="problem" hidden="">')


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
