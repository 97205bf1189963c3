#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The command line says what it can do in four places that must agree: help, man page, bash completion, and the answer to a
mistake. What `parameters` prints can be read back. Arguments: PROGRAM REPOSITORY WORK.
"""

import functools
import json
import os
import re
import subprocess
import sys
import unittest

PROGRAM, REPOSITORY, WORK = map(os.path.abspath, sys.argv[1:4])
os.makedirs(WORK, exist_ok=True)
SCENE = os.path.join(REPOSITORY, "parameters/gallery/two_disks.prm")
OWN_COMMANDS = ("run", "check", "parameters", "measure")  # whose options are those of the program, not of a script


def softgrain(*words):
    done = subprocess.run([PROGRAM, *words], cwd=WORK, capture_output=True, text=True, check=False)
    return done.returncode, done.stdout, done.stderr


@functools.lru_cache(maxsize=None)
def help_of(*words):
    status, text, errors = softgrain(*words, "--help")
    assert (status, errors) == (0, ""), (words, errors)
    return text


def commands(*words):
    """Names below 'Subcommands:' in the help."""
    text = help_of(*words).partition("Subcommands:\n")[2].split("\n\n")[0]
    return re.findall(r"^  ([a-z][\w-]*)", text, re.M)


def options(command):
    text = help_of(command).partition("Options:\n")[2].split("\n\n")[0]
    return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", text, re.M))


class Help(unittest.TestCase):
    def test_examples_are_understood(self):
        """Every example of the help names a command and options that exist."""
        seen = 0
        for words in ([], *([name] for name in commands()[:-1] if name in OWN_COMMANDS), ["figures"]):
            for example in re.findall(r"^  softgrain (.*)", help_of(*words).partition("Examples:")[2], re.M):
                command, *rest = example.split()
                self.assertIn(command, commands())
                if command in OWN_COMMANDS:
                    self.assertLessEqual({word for word in rest if word.startswith("--")}, options(command), example)
                seen += 1
        self.assertGreater(seen, 15)

    def test_nearest_name(self):
        for words, said in (
                (["chek", SCENE], "'softgrain' has no command 'chek' (did you mean 'check'?); there are run, check,"),
                (["parameter"], "did you mean 'parameters'?"),
                (["figures", "thesis-6", "out"], "'figures' has no command 'thesis-6' (did you mean 'thesis-"),
                (["run", SCENE, "--ouptut", "out"], "'run' has no option '--ouptut' (did you mean '--output'?)"),
                (["check", SCENE, "--restart"], "'check' has no option '--restart'"),
                (["parameters", "--fromat=md"], "did you mean '--format'?"),
                (["figures"], "no command after 'figures'; there are thesis-3, thesis-4, thesis-5"),
                ([], "no command after 'softgrain'; there are run, check")):
            status, printed, errors = softgrain(*words)
            self.assertEqual((status, printed), (2, ""), words)
            self.assertRegex(errors, r"^softgrain: error: [^\n]+\n$")
            self.assertIn(said, errors)
        self.assertNotIn("did you mean", softgrain("dance")[2])


class ManualPage(unittest.TestCase):
    def test_commands_and_options(self):
        with open(os.path.join(REPOSITORY, "doc/softgrain.1"), encoding="utf-8") as file:
            page = re.sub(r"\\f[BIR]", "", file.read()).replace("\\-", "-")
        described = page.partition(".SH COMMANDS")[2].partition(".SH OPTIONS")[0]
        names = [name for name in commands() if name != "figures"] + [f"figures {name}" for name in commands("figures")]
        self.assertEqual(re.findall(r"^\.TP\n\.B[IR]? \"?([a-z]+(?: thesis-\d)?)", described, re.M), names)
        mentioned = set(re.findall(r"--[a-z-]+", page.partition(".SH OPTIONS")[2].partition(".SH EXIT")[0]))
        known = {"--version"}.union(*(options(name) for name in OWN_COMMANDS))
        self.assertEqual(mentioned, known)


class Completion(unittest.TestCase):
    """What pressing Tab offers after some words, of which the last is not finished."""

    CASES = [("",), ("c",), ("figures", ""), *((name, "--") for name in OWN_COMMANDS), ("render", "--"),
             ("figures", "thesis-4", "--r"), ("parameters", "--format", ""), ("parameters", "--model", "b"),
             ("measure", "--measures", ""), ("render", "out", "--contacts", ""), ("run", "x.prm", "--set", ""),
             ("run", "files/"), ("render", "files/b")]

    @classmethod
    def setUpClass(cls):
        os.makedirs(os.path.join(WORK, "files/below"), exist_ok=True)
        for name in ("a.prm", "b.json", "c.png"):
            open(os.path.join(WORK, "files", name), "w", encoding="utf-8").close()
        # One shell for all: it asks the program once for every help.
        script = ('source "$1"; while IFS= read -r line; do mapfile -t -d, COMP_WORDS < <(printf "%s," "$2,$line"); '
                  'COMP_CWORD=$((${#COMP_WORDS[@]} - 1)); _softgrain; echo "${COMPREPLY[*]}"; done')
        cls.done = subprocess.run(["bash", "-c", script, "bash", os.path.join(REPOSITORY, "contrib/softgrain.bash"),
                                   PROGRAM], input="".join(",".join(case) + "\n" for case in cls.CASES),
                                  cwd=WORK, capture_output=True, text=True, check=True)
        cls.answers = dict(zip(cls.CASES, cls.done.stdout.split("\n")))

    def offered(self, *words):
        self.assertEqual(self.done.stderr, "")
        return set(self.answers[words].split())

    def test_commands(self):
        self.assertEqual(self.offered(""), set(commands()))
        self.assertEqual(self.offered("c"), {"check"})
        self.assertEqual(self.offered("figures", ""), set(commands("figures")))

    def test_options(self):
        for name in OWN_COMMANDS:
            self.assertEqual(self.offered(name, "--"), options(name))
        self.assertLessEqual({"--frame", "--field", "--output"}, self.offered("render", "--"))
        self.assertLessEqual({"--reference"}, self.offered("figures", "thesis-4", "--r"))

    def test_values(self):
        self.assertEqual(self.offered("parameters", "--format", ""), {"prm", "json", "md"})
        self.assertEqual(self.offered("parameters", "--model", "b"), {"bpm"})
        self.assertIn("stress", self.offered("measure", "--measures", ""))
        self.assertIn("chains", self.offered("render", "out", "--contacts", ""))
        self.assertEqual(self.offered("run", "x.prm", "--set", ""), set())

    def test_files(self):
        self.assertEqual(self.offered("run", "files/"), {"files/a.prm", "files/b.json", "files/below"})
        self.assertEqual(self.offered("render", "files/b"), {"files/below"})


class Listing(unittest.TestCase):
    MESH = ["--set", "Mesh/Lower=-6e-3, -6e-3", "--set", "Mesh/Upper=6e-3, 6e-3", "--set", "Mesh/Cell size=1e-3"]
    BODY = ["--set", "Bodies/NAME/Radius=5e-3", "--set", "Stop/End time=1e-3"]

    def listing(self, model, form):
        path = os.path.join(WORK, f"{model}.{form}")
        status, text, errors = softgrain("parameters", "--model", model, "--format", form)
        self.assertEqual((status, errors), (0, ""))
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def test_it_can_be_read(self):
        for model, changes in (("mpm", self.MESH + self.BODY),
                               ("bpm", self.BODY + ["--set", "Primaries/Smallest diameter=5e-4",
                                                    "--set", "Primaries/Largest diameter=7e-4"])):
            reports = []
            for form in ("json", "prm"):
                path = self.listing(model, form)
                status, printed, errors = softgrain("check", path, *changes, "--output", "there")
                self.assertEqual((status, errors), (0, ""), path)
                # Processor time is that of the machine, which is measured each time.
                reports.append(re.sub(r"(processor time +).*", r"\1", printed))
                # What is missing is said of the scene, not of an entry that is not known.
                status, _, errors = softgrain("check", path)
                self.assertEqual(status, 2)
                self.assertNotIn("unknown", errors)
            self.assertEqual(*reports)

    def test_described_parameters(self):
        for text, said in (
                ({"Threads": {"value": "2", "colour": "red"}}, "'Threads/colour' cannot stand beside a \"value\""),
                ({"Threads": {"value": "2", "Deeper": {"value": "1"}}}, "cannot stand beside a \"value\""),
                ({"Treads": {"value": "2"}}, "unknown parameter 'Treads' (did you mean 'Threads'?)"),
                ({"Threads": {"value": "many", "default": "0"}}, ":2: 'Threads' = 'many' is not allowed")):
            path = os.path.join(WORK, "described.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(text, file, indent=1)
            status, _, errors = softgrain("check", path)
            self.assertEqual(status, 2, errors)
            self.assertIn(said, errors)


class CheckRanks(unittest.TestCase):
    """What falls to one rank: less the more there are, but not below what all do alike; a bound on how many help."""

    def said(self, scene, ranks):
        status, printed, errors = softgrain("check", os.path.join(REPOSITORY, "parameters", scene), "--ranks", str(ranks))
        self.assertEqual((status, errors), (0, ""))
        seconds = {}
        for name, text in re.findall(r"(processor time|of one of) .*about (.*?)(?: of processor time.*)?$", printed, re.M):
            numbers = re.findall(r"([\d.]+) (h|min|s)", text)
            seconds[name] = sum(float(number) * {"h": 3600, "min": 60, "s": 1}[unit] for number, unit in numbers)
        return seconds["of one of"] / seconds["processor time"], printed

    def test_shares(self):
        # Share of the work that is divided, of 300 grains, see doc/ranks.md: that of MPM is measured, bonded primaries have nothing that all do.
        for scene, divided in (("thesis/uniaxial_compaction_mpm.prm", 0.86), ("thesis/uniaxial_compaction_bpm.prm", 1.)):
            for ranks in (1, 4, 16):
                share, printed = self.said(scene, ranks)
                # There are two digits, and an extra part for the start of the program.
                self.assertAlmostEqual(share, 1 - divided * (1 - 1 / ranks), delta=0.02 + 0.06 * share)
                self.assertNotIn("there is work for", printed)

    def test_memory(self):
        # 160 MB of every process, and of the points a share of 0.8 is divided; two digits are told.
        for ranks in (2, 8):
            _, printed = self.said("thesis/uniaxial_compaction_mpm.prm", ranks)
            whole, of_rank = (float(re.search(rf"^  {name} +about (\d+) MB", printed, re.M).group(1)) - 160.
                              for name in ("memory", "memory of a rank"))
            self.assertAlmostEqual(of_rank / whole, 1 - 0.8 * (1 - 1 / ranks), delta=0.06)

    def test_too_many(self):
        _, printed = self.said("gallery/two_disks.prm", 4)
        self.assertEqual(printed.count("warning: 4 ranks, but there is work for about 2\n"), 1, printed)

    def test_refused(self):
        status, _, errors = softgrain("check", SCENE, "--ranks", "0")
        self.assertEqual((status, errors.count("--ranks")), (2, 1), errors)


class Warnings(unittest.TestCase):
    def test_law_that_is_not_chosen(self):
        """What is set for another law than that of the material is read by nobody."""
        said = r"^warning: 'Materials/gel/(.*)' has no effect with 'Law' = '(.*)', which reads '(.*)'$"
        for words, expected in (
                ([], []),
                (["--set", "Materials/gel/Law=hencky"], [("Neo-Hookean", "hencky", "Hencky")]),
                (["--set", "Materials/gel/Gent/Poisson's ratio=0.3"], [("Gent", "neo_hookean", "Neo-Hookean")])):
            status, printed, errors = softgrain("check", SCENE, *words)
            self.assertEqual((status, errors), (0, ""))
            self.assertEqual(re.findall(said, printed, re.M), expected)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
