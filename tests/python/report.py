# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The page of `softgrain report`: its data are those of history.csv, it asks for nothing from outside, and a browser shows it
without an error. Arguments: see common.py.
"""

import csv
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

import common
import numpy as np
import softgrain
from softgrain.page import LIBRARY, Page, read_data
from softgrain.report import Choices, report
from tool_runs import run

BROWSER = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)


def columns_of(path):
    """A table by means that are not those of the package."""
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.reader(file))
    return {name: [float(row[i]) if row[i] else None for row in rows[1:]] for i, name in enumerate(rows[0])}


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


class Report(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.other = os.path.join(common.WORK, "other")
        softgrain.run(common.SCENE, output=cls.other, threads=1, set={"Contact/Friction": 0.4, "Stop/Axial strain": 0.03})
        code, printed, errors = run("report.py", common.EXAMPLE, cls.other, "--labels", "smooth", "rough <&>", "--output",
                                    "both.html", "--frames", "3")
        assert (code, printed, errors) == (0, "both.html\n", ""), errors
        cls.text = text_of("both.html")
        cls.data = read_data(cls.text)

    def test_tables_are_those_of_the_runs(self):
        for number, folder in enumerate((common.EXAMPLE, self.other)):
            for name in ("history", "measures"):
                shown = self.data["tables"][f"{number}/{name}"]
                written = columns_of(os.path.join(folder, name + ".csv"))
                self.assertLessEqual(set(written), set(shown))
                for column, values in written.items():
                    self.assertEqual(shown[column], [None if value != value else value for value in values], column)
        # The strain of a measure is that of the history at its time.
        history, measures = (self.data["tables"][f"0/{name}"] for name in ("history", "measures"))
        np.testing.assert_allclose(measures["axial_strain"], np.interp(measures["time_s"], history["time_s"],
                                                                       history["axial_strain"]), atol=1e-12)

    def test_curves_show_columns_that_exist(self):
        curves = [chart for chart in self.data["charts"] if "series" in chart]
        self.assertGreater(len(curves), 5)
        for chart in curves:
            self.assertEqual(len({series["name"] for series in chart["series"]}), len(chart["series"]), chart["heading"])
            for series in chart["series"]:
                y = series.get("y", chart["y"][0])
                for x in chart["x"]:
                    if x in self.data["tables"][series["tables"][0]]:
                        self.assertTrue(any({x, y} <= set(self.data["tables"][table]) for table in series["tables"]), (x, y))
        unit = self.data["columns"]["top_force_N_per_m"]
        largest = max(max(self.data["tables"][f"{i}/history"]["top_force_N_per_m"]) for i in (0, 1))
        self.assertIn(unit["unit"], ("N/m", "kN/m"))
        self.assertTrue(1 <= largest / unit["divisor"] < 1000)

    def test_dissipation(self):
        """A stack for each run, whose top is what is dissipated in all, over what the scenes go by."""
        found = [chart for chart in self.data["charts"] if chart["heading"].startswith("Dissipation by kind, ")]
        self.assertEqual([chart["heading"].rpartition(", ")[2] for chart in found], ["smooth", "rough <&>"])
        for number, chart in enumerate(found):
            self.assertEqual((chart["x"][0], chart["follow"]), ("axial_strain", True))
            self.assertTrue(all(series["stack"] for series in chart["series"]))
            table = self.data["tables"][f"{number}/dissipation"]
            whole = self.data["tables"][f"{number}/history"]["dissipated_energy_J_per_m"][-1]
            self.assertAlmostEqual(sum(table[series["y"]][-1] for series in chart["series"]) / whole, 1, delta=1e-3)

    def test_numbers_and_parameters(self):
        summary = softgrain.open(common.EXAMPLE).summary
        self.assertIn(f"<td>{summary['steps']}</td>", self.text)
        rows = re.findall(r'<tr class="differs"><th>([^<]*)</th><td>([^<]*)</td><td>([^<]*)</td>', self.text)
        self.assertEqual(sorted(rows), [("Axial strain", "0.08", "0.03"), ("Friction", "0", "0.4")])
        bars = next(chart for chart in self.data["charts"] if chart.get("height"))["traces"]
        self.assertEqual({bar["name"]: bar["x"][0] for bar in bars}, summary["phases"])
        self.assertIn("rough &lt;&amp;&gt;", self.text)
        self.assertNotIn("rough <&>", self.text[:self.text.index('id="data"')])

    def test_nothing_comes_from_outside(self):
        # The library as its makers wrote it, with its licence; all else asks for nothing.
        library = text_of(os.path.join(common.PYTHON, os.pardir, "contrib/third-party", LIBRARY))
        self.assertIn("MIT license", library[:200])
        self.assertEqual(self.text.count(library), 1)
        addresses = re.findall(r'(?:src|href)="([^"]{0,40})', self.text.replace(library, ""))
        self.assertGreater(len(addresses), 8)
        for address in addresses:
            self.assertRegex(address, r"^(data:(image/png|image/gif|video/mp4);base64,|#)")
        self.assertIn("default-src 'none'", self.text)

    def test_it_ends_where_it_should(self):
        page = Page("</script><b>")
        page.tables["a"] = {"x": ["</script>"]}
        self.assertEqual(page.html().count("</script>"), 3)
        self.assertEqual(read_data(page.html())["tables"], page.tables)

    def test_running_and_failed(self):
        for status, said in (("running", "it may have been killed"), ("failed", "the run failed"),
                             ("interrupted", "--restart goes on")):
            folder = os.path.join(common.WORK, status)
            shutil.copytree(common.EXAMPLE, folder)
            summary = json.loads(text_of(os.path.join(folder, "summary.json")))
            with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
                json.dump({**summary, "status": status, "energy_balance_error": 0.2, "max_contact_residual": 0.3}, file)
            for name in ("summary.json", "history.csv"):
                os.utime(os.path.join(folder, name), (0, 0))
            text = report([softgrain.open(folder)], Choices(film=False)).html()
            warnings = text.partition('<ul class="warnings">')[2].partition("</ul>")[0]
            self.assertEqual(warnings.count("<li>"), 3, warnings)
            for words in (said, "the energy balance is off by 0.2", "the largest residual is 3.0e-01"):
                self.assertIn(words, warnings)
        self.assertNotIn('<ul class="warnings">', self.text)

    def test_from_the_history_while_it_runs(self):
        folder = os.path.join(common.WORK, "early")
        shutil.copytree(common.EXAMPLE, folder)
        summary = json.loads(text_of(os.path.join(folder, "summary.json")))
        with open(os.path.join(folder, "summary.json"), "w", encoding="utf-8") as file:
            json.dump({**summary, "status": "running", "steps": 0, "simulated_time_s": 0., "wall_seconds": 0.}, file)
        text = report([softgrain.open(folder)], Choices(film=False)).html()
        self.assertIn("the run goes on", text)
        self.assertIn(f"<th>steps</th><td>{summary['steps']}</td>", text)
        self.assertNotIn("time it took", text)
        self.assertIn("time it took", self.text)

    def test_what_is_missing(self):
        bare = os.path.join(common.WORK, "bare")
        os.makedirs(bare)
        shutil.copy(os.path.join(common.EXAMPLE, "history.csv"), bare)
        text = report([softgrain.open(bare)]).html()
        self.assertIn("there is no summary.json", text)
        self.assertEqual(read_data(text)["tables"]["0/history"], columns_of(os.path.join(bare, "history.csv")))
        for words, arguments in (("there is no folder", ["nowhere"]), ("no output folder of a run", [common.PYTHON]),
                                 ("--labels gives 1 names for 2 runs", [bare, bare, "--labels", "a"]),
                                 ("must be .html", [bare, "--output", "page.pdf"]), ("must be 2 to", [bare, "--frames", "1"])):
            code, _, errors = run("report.py", *arguments)
            self.assertEqual((code, len(errors.splitlines())), (2, 1), errors)
            self.assertIn(words, errors)

    @unittest.skipUnless(BROWSER, "no Chromium is there to open the page")
    def test_a_browser_shows_it(self):
        for width in (1400, 420):
            done = subprocess.run(
                [BROWSER, "--headless", "--no-sandbox", "--disable-gpu", f"--window-size={width},900", "--dump-dom",
                 "--virtual-time-budget=10000", "--enable-logging=stderr", "--v=0",
                 f"--user-data-dir={os.path.join(common.WORK, 'profile')}", "file://" + os.path.abspath("both.html")],
                capture_output=True, text=True, timeout=240, check=True)
            self.assertEqual([line for line in done.stderr.splitlines() if ":CONSOLE" in line], [])
            shown = done.stdout
            n = len(self.data["charts"])
            self.assertIn(f'data-drawn="{n}"', shown)
            self.assertRegex(shown, r'<div id="problem" hidden="">')
            self.assertEqual(len(re.findall(r'class="plot[^>]*>\s*<div class="plot-container', shown)), n)
            # Every curve has its line.
            self.assertGreater(len(re.findall(r'class="js-line"', shown)), 2 * n)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=1)
