# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Pages about runs and studies of somebody else: whatever their files say, it is shown as text. A page is read by Python's own
parser of HTML; no element and no attribute may come from the data. Arguments: see common.py.
"""

import csv
import html.parser
import json
import os
import re
import shutil
import subprocess
import sys
import unittest

import common
import softgrain
from softgrain.page import read_data
from softgrain.report import Choices, report
from softgrain.runner import write_record
from softgrain.study import Session
from softgrain.study_page import study_page
from softgrain.study_picture import draw_study
from softgrain.study_text import print_findings

BROWSER = next((found for name in ("chromium", "chromium-browser", "google-chrome") if (found := shutil.which(name))), None)
SCRIPT = "document.title='broken'"
# Ends whatever it may stand in: a text, an attribute, a script, a comment, a style, a formula.
PAYLOAD = (f"\"'><img src=x onerror={SCRIPT}><svg onload={SCRIPT}></title></style></textarea></script><script>{SCRIPT}</script>"
           f"--><a href=javascript:{SCRIPT}>$\\frac$ %{{x}}")
NO_BLANK = PAYLOAD.replace(" ", "/")
ELEMENTS = {"html", "head", "meta", "title", "style", "body", "header", "h1", "h2", "h3", "div", "span", "nav", "a", "main",
            "section", "ul", "li", "i", "p", "table", "thead", "tbody", "tr", "th", "td", "input", "figure", "figcaption", "img",
            "video", "pre", "footer", "script"}
ATTRIBUTES = {"lang", "charset", "http-equiv", "content", "name", "class", "id", "style", "href", "hidden", "type", "placeholder",
              "aria-label", "colspan", "src", "alt", "controls", "loop", "muted", "playsinline", "preload"}


class Elements(html.parser.HTMLParser):
    """Elements, attributes and the text of a page."""

    def __init__(self, text):
        super().__init__()
        self.found, self.text, self.inside = [], "", None
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attrs):
        self.found.append((tag, attrs))
        self.inside = tag

    def handle_data(self, data):
        if self.inside not in ("script", "style"):
            self.text += data

    def handle_endtag(self, tag):
        self.inside = None


def write(name, text):
    folder = os.path.dirname(name)
    if folder:
        os.makedirs(folder, exist_ok=True)
    with open(name, "w", newline="", encoding="utf-8") as file:
        file.write(text)
    return name


def table(columns, n=5):
    lines = [[float(row * (1 + place)) for place in range(len(columns))] for row in range(n)]
    path = "table.csv.part"
    with open(path, "w", newline="", encoding="utf-8") as file:
        csv.writer(file).writerows([columns, *lines])
    with open(path, newline="", encoding="utf-8") as file:
        return file.read()


def make_run(folder, own=PAYLOAD, status=None):
    """A folder as a run leaves it, with @own wherever there is a text."""
    summary = {"status": status or own, "model": own, "version": own, "steps": own, "bodies": [own], "threads": None, own: own,
               "wall_seconds": 3., "peak_memory_bytes": 1e6, "energy_balance_error": own, "phases": {own: 1., "contact": own, "b": 2.}}
    write(f"{folder}/summary.json", json.dumps(summary))
    columns = ["time_s", "step", "top_force_N_per_m", "kinetic_energy_J_per_m", f"{own}_force_N_per_m", own.replace("_", "-")]
    write(f"{folder}/history.csv", table(columns))
    write(f"{folder}/measures.csv", table(["time_s", f"{own}_Pa", "packing_fraction"]))
    write(f"{folder}/parameters.prm", f"set Model = mpm\nset {own.replace('=', ' ')} = {own}\nsubsection {own}\n"
                                      f"  set Law = {own}\nend\n")
    write(f"{folder}/run.log", f"{own}\n\x1b[2J{own}\n")


class Pages(unittest.TestCase):
    def check(self, text, shown):
        """Nothing of the page came from the data, but what they say is there to be read."""
        page = Elements(text)
        self.assertLessEqual({tag for tag, _ in page.found}, ELEMENTS)
        self.assertEqual([tag for tag, _ in page.found].count("script"), 3)
        for tag, attributes in page.found:
            self.assertLessEqual({name for name, _ in attributes}, ATTRIBUTES, tag)
            for name, value in attributes:
                if name in ("href", "src"):
                    self.assertRegex(value, r"^(#[a-z0-9-]*$|data:(image|video)/)")
                elif name not in ("alt", "content"):
                    self.assertNotIn("title", value or "", (tag, name))
        for words in shown:
            self.assertIn(words, page.text)
        # Texts of the charts may have elements for symbols; those of others are escaped in them, too.
        data = read_data(text)
        for label in [one["label"] for one in data["columns"].values()] + [
                trace.get("name", "") for chart in data["charts"] for trace in chart.get("traces", [])] + [
                    series["name"] for chart in data["charts"] for series in chart.get("series", [])]:
            self.assertLessEqual(set(re.findall(r"</?(\w+)", label)), {"i", "sub", "sup"}, label)
        script = text[text.index('id="data">'):]
        self.assertNotIn("<", script[len('id="data">'):script.index("</script>")])

    def test_report(self):
        folder = f"run {NO_BLANK}".replace("/", "|")
        make_run(folder)
        make_run("plain", own="plain <b>")
        for folders, labels in (([folder], None), ([folder, "plain"], None), ([folder, "plain"], [PAYLOAD, "b"])):
            runs = [softgrain.open(one) for one in folders]
            text = report(runs, Choices(film=False, title=PAYLOAD if labels else None, labels=labels)).html()
            self.check(text, [PAYLOAD, folder])
        write("hostile_report.html", text)
        self.browse("hostile_report.html")

    def test_report_of_damaged_files(self):
        """What is no summary is refused with one line."""
        for bad in ("[1, 2]", "3", "null", "{", '"' + PAYLOAD + '"'):
            make_run("damaged")
            write("damaged/summary.json", bad)
            with self.assertRaises(softgrain.InputError) as caught:
                report([softgrain.open("damaged")], Choices(film=False))
            self.assertNotIn("\n", str(caught.exception))

    def test_study(self):
        write("hostile_scene.prm", "set Model = mpm\n")
        write("hostile_study.prm", f"""set Scene = hostile_scene.prm
set Title = {PAYLOAD.replace('#', '')}
set Reference = kind = a
subsection Knobs
  set Names = kind
  subsection kind
    set Parameter = Output directory
    set Values = a; {PAYLOAD.replace(';', '')}; b
  end
end
subsection Quantities
  set Names = force
  subsection force
    set Column = top_force
    set At = 1, 2, 3
  end
end
""")
        session = Session("hostile_study.prm", "hostile_output")
        for number, (task, _) in enumerate(session.statuses()):
            os.makedirs("hostile_output/runs", exist_ok=True)
            write_record(os.path.join("hostile_output/runs", task.name), task.changes, {"status": "completed" if number else "completed", "cpu_seconds": 1. + number,
                                                  "wall_seconds": 1., **({"error": PAYLOAD} if number == 1 else {})})
            make_run(os.path.join("hostile_output/runs", task.name), status="completed")
        findings = session.findings()
        print_findings(findings)
        draw_study(findings).savefig("hostile_study.png")
        text = study_page(findings, pictures=False).html()
        self.check(text, [PAYLOAD])
        self.browse(write("hostile_study.html", text))

    def browse(self, path):
        if not BROWSER:
            return  # the rest of the test needs none
        done = subprocess.run([BROWSER, "--headless", "--no-sandbox", "--disable-gpu", "--virtual-time-budget=5000",
                               "--dump-dom", "file://" + os.path.abspath(path)], capture_output=True, text=True, timeout=100,
                              check=False)
        self.assertIn("data-drawn", done.stdout)
        self.assertNotIn("<title>broken</title>", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
