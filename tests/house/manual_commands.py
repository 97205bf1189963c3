#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Runs the commands of a page of the manual as a reader would: every fenced block marked `sh`, in a folder that looks like a
checkout with a finished build. Blocks marked `prm` must be understood, and commands within a line must exist with their
options. A comment before a block changes what is done with it:

    <!-- not run: REASON -->          REASON is one of NOT_RUN below
    <!-- test with: --set "…" -->     these words are added to every `softgrain run` of the block, to end it sooner

Pages of doc/results hold long series: there `run` becomes `check`, and pictures are not drawn.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path

NOT_RUN = ("installs packages", "runs all tests", "compiles, as the test constitutive/custom_law_alone does",
           "compiles; the test nightly/installed_package packs", "a nightly test does the same",
           "starts ranks, as the tests app/ranks do", "needs a scheduler", "runs until it is stopped", "needs a display",
           "needs a container tool", "needs other codes", "builds a Debian package",
           "test house/reference_manual does")
COPIED = ("parameters", "doc", "examples", "cmake", "contrib", "include", "source")
LANGUAGES = ("sh", "prm", "text", "python", "cpp", "json")
FENCE = re.compile(r"^```(\S*)\s*$")
COMMENT = re.compile(r"^<!-- (not run|test with): (.*) -->$")
INLINE = re.compile(r"`((?:softgrain|\./quickstart) [^`]+)`")
OPTION = re.compile(r"(?<![\w-])--[a-z][a-z-]*")
HELPERS = Path(__file__).resolve().parent / "manual_stand_ins"


class Block:
    def __init__(self, line, language, marks):
        self.line, self.language, self.marks, self.text = line, language, marks, ""


def blocks_and_prose(text):
    """Fenced blocks with the comments before them, and the other lines with their numbers."""
    blocks, prose, marks, inside = [], [], {}, None
    for number, line in enumerate(text.splitlines(), 1):
        fence = FENCE.match(line.strip())
        if inside is not None:
            if fence:
                blocks.append(inside)
                inside = None
            else:
                inside.text += line + "\n"
        elif fence:
            inside, marks = Block(number, fence[1], marks), {}
        elif comment := COMMENT.match(line.strip()):
            marks[comment[1]] = comment[2]
        elif line.strip():
            marks = {}
            prose.append((number, line))
    return blocks, prose


class Page:
    """One page, with the folder in which its commands run."""

    def __init__(self, root, page, program, work):
        self.root, self.name, self.program = root, page, program
        self.results = page.startswith("doc/results/")
        self.folder = Path(work) / re.sub(r"\W", "_", page)
        self.helps = {}
        self.text = (root / page).read_text(encoding="utf-8")

    def prepare(self):
        shutil.rmtree(self.folder, ignore_errors=True)
        for name in ("build/release/bin", "build/release/tests/performance", "bin"):
            (self.folder / name).mkdir(parents=True)
        for name in COPIED:  # a copy, so that no command of a page can change the sources
            shutil.copytree(self.root / name, self.folder / name, ignore=shutil.ignore_patterns("pictures", "__pycache__"))
        shutil.copy(self.root / "quickstart", self.folder)
        for place in ("build/release/bin/softgrain", "bin/softgrain", "bin/B"):
            (self.folder / place).symlink_to(HELPERS / "softgrain")
        for name in ("cmake", "ninja", "dpkg-query"):
            (self.folder / "bin" / name).symlink_to(HELPERS / "nothing_to_do")
        if self.results:
            for script in (self.root / "contrib/results").glob("*.py"):
                (self.folder / "contrib/results" / script.name).unlink()
                (self.folder / "contrib/results" / script.name).symlink_to(HELPERS / "result_script")
            (self.folder / "build/release/tests/performance/disk_solver_benchmark").symlink_to(HELPERS / "nothing_to_do")

    def softgrain(self, *words):
        return subprocess.run([self.program, *words], cwd=self.folder, capture_output=True, text=True, check=False)

    def help_of(self, words):
        """The help of a command, of `figures NAME` too; '' when there is none."""
        words = tuple(words[:2] if words[0] == "figures" else words[:1])
        if words not in self.helps:
            done = self.softgrain(*words, "--help")
            # An unknown command is answered with the help of the program.
            known = done.returncode == 0 and "Usage: softgrain [OPTIONS] SUBCOMMAND" not in done.stdout
            self.helps[words] = done.stdout if known else ""
        return self.helps[words]

    def check_inline(self, prose):
        for number, line in prose:
            for command in INLINE.findall(line):
                name, *words = command.split()
                options = OPTION.findall(command)
                if name == "./quickstart":
                    text = (self.root / "quickstart").read_text(encoding="utf-8")
                    known = words[0].startswith("-") or re.search(rf"^  {re.escape(words[0])}\)", text, re.M)
                    allowed = text
                elif words[0].isupper() or words[0] == "…":  # any command
                    continue
                else:
                    known = allowed = self.help_of(words) if not words[0].startswith("-") else self.softgrain("--help").stdout
                if not known:
                    yield f"{self.name}:{number}: there is no `{command}`"
                else:
                    yield from (f"{self.name}:{number}: `{command}`: there is no {option}" for option in options
                                if not re.search(rf"(?<![\w-]){option}(?![\w-])", allowed))

    def check_parameters(self, block):
        """A part of a parameter file: what is missing does not matter, what is there must be known."""
        path = self.folder / f"block-{block.line}.prm"
        path.write_text(block.text, encoding="utf-8")
        done = self.softgrain("check", path.name)
        said = done.stderr.replace("must be one of (none)", "")  # no materials: not what the block is about
        if done.returncode and re.search(r"unknown|: it must be|is not understood|has no '='|no 'end'|twice", said):
            yield f"{self.name}:{block.line}: {done.stderr.strip()}"

    def run_block(self, block):
        environment = {**os.environ, "PATH": f"{self.folder}/bin:{os.environ['PATH']}", "SOFTGRAIN": str(self.program),
                       "SOFTGRAIN_SOURCE": str(self.root), "PYTHONDONTWRITEBYTECODE": "1",
                       "SOFTGRAIN_MODE": "check" if self.results else "run",
                       "SOFTGRAIN_ADDED": block.marks.get("test with", "")}
        begin = time.monotonic()
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", block.text], cwd=self.folder, env=environment,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              check=False)
        print(f"{self.name}:{block.line}: status {done.returncode}, {time.monotonic() - begin:.1f} s", flush=True)
        if done.returncode != 0:
            yield f"{self.name}:{block.line}: this block fails:\n{block.text}--- with\n{done.stdout[-3000:]}"

    def findings(self):
        blocks, prose = blocks_and_prose(self.text)
        self.prepare()
        yield from self.check_inline(prose)
        for block in blocks:
            language = block.language or ("sh" if self.results else "")
            reason = block.marks.get("not run")
            if language not in LANGUAGES:
                yield f"{self.name}:{block.line}: say what this block is: {', '.join(LANGUAGES)}"
            elif reason is not None and reason not in NOT_RUN:
                yield f"{self.name}:{block.line}: '{reason}' is no reason not to run it: {'; '.join(NOT_RUN)}"
            elif reason is not None:
                print(f"{self.name}:{block.line}: not run: {reason}")
            elif language == "prm":
                yield from self.check_parameters(block)
            elif language == "sh":
                yield from self.run_block(block)


SAMPLE = """# Sample
`softgrain check FILE --threads 2` and `softgrain chek FILE`, `softgrain check --thread 2`, `./quickstart dance`

```sh
softgrain check parameters/gallery/two_disks.prm
test -e parameters/gallery && echo fine
```
```sh
softgrain check parameters/gallery/nothing.prm
```

<!-- not run: tedious -->
```sh
true
```
<!-- not run: installs packages -->
```sh
false
```
```
what is this
```
```prm
subsection Output
  set Fields evry = 1
end
```
```prm
subsection Output
  set Fields every = 1
end
```
<!-- test with: --set "Stop/End time=1e-5" -->
```sh
softgrain run parameters/gallery/two_disks.prm --threads 1
grep -q '"simulated_time_s": 1e-05' output/two_disks/summary.json
```
"""
FOUND = ((2, "there is no `softgrain chek FILE`"), (2, "there is no --thread"), (2, "there is no `./quickstart dance`"),
         (8, "this block fails"), (13, "'tedious' is no reason"), (20, "say what this block is"), (23, "unknown parameter"))


def self_test(program, root, work):
    """A page with one fault each: all of them are found, and nothing else."""
    shutil.rmtree(work, ignore_errors=True)
    sample = Path(work) / "root"
    sample.mkdir(parents=True)
    for name in (*COPIED, "quickstart"):
        (sample / name).symlink_to(root / name)
    (sample / "page.md").write_text(SAMPLE, encoding="utf-8")
    found = list(Page(sample, "page.md", program, work).findings())
    expected = [any(one.startswith(f"page.md:{line}:") and text in one for one in found) for line, text in FOUND]
    if all(expected) and len(found) == len(FOUND):
        return []
    return [f"expected {FOUND}, found:", *found]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    parser.add_argument("--program", type=Path, required=True, help="the program that was built")
    parser.add_argument("--work", type=Path, required=True, help="folder to run in; what is there is removed")
    parser.add_argument("pages", nargs="*", help="relative to the root; none: a test of this test")
    arguments = parser.parse_args()
    root, program, work = (path.resolve() for path in (arguments.root, arguments.program, arguments.work))
    findings = [] if arguments.pages else self_test(program, root, work)
    for page in arguments.pages:
        findings += Page(root, page, program, work).findings()
    print(*findings, sep="\n")
    print(f"{len(findings)} finding(s)")
    sys.exit(1 if findings else 0)


if __name__ == "__main__":
    main()
