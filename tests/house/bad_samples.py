#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Each check of contrib/checks accepts a good sample and finds what is wrong with bad ones: bad_samples.py CHECK."""
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LICENCE = "// SPDX-License-Identifier: LGPL-2.1-or-later\n"


def header(guard, body=""):
    return f"{LICENCE}#ifndef {guard}\n#define {guard}\n{body}\n#endif\n"


LISTS = {"cmake/targets.cmake": "set(SOFTGRAIN_PARTS base contact mpm)\n",
         "tests/CMakeLists.txt": "foreach(extra house nightly)\nendforeach()\n"}

# Per check: files that pass, then pairs of files that must not pass and what the check must say of them.
SAMPLES = {
    "include_direction": (
        {"include/softgrain/mpm/a.h": "#include <softgrain/contact/b.h>\n#include <deal.II/base/tensor.h>\n",
         "source/contact/b.cc": "#include <softgrain/contact/b.h>\n#include <deal.II/base/tensor.h>\n"},
        [({"include/softgrain/contact/b.h": "#include <softgrain/mpm/a.h>\n"}, "contact may not include mpm"),
         ({"source/mpm/a.cc": "#include <softgrain/bpm/a.h>\n"}, "mpm may not include bpm"),
         ({"bpm/source/a.cc": "#  include <softgrain/constitutive/law.h>\n"}, "bpm may not include constitutive"),
         ({"source/scene/a.cc": "#include <softgrain/constitutive/law.h>\n"}, "scene may not include constitutive"),
         ({"source/output/a.cc": "#include <softgrain/mpm/a.h>\n"}, "output may not include mpm"),
         ({"source/base/a.cc": "#include <softgrain/app/a.h>\n"}, "base may not include app"),
         ({"include/softgrain/contact/b.h": "#include <deal.II/base/tensor.h>\n"}, "know nothing of deal.II"),
         ({"include/softgrain/nowhere/b.h": ""}, "'nowhere' is not a part"),
         ({"source/base/a.cc": '#include "a.h"\n'}, "write <softgrain/...>")]),
    "formatting": (
        {"a.cc": "int main()\n{\n  return 0;\n}\n", ".clang-format": (ROOT / ".clang-format").read_text()},
        [({"a.cc": "int main() { return   0; }\n", ".clang-format": (ROOT / ".clang-format").read_text()},
          "a.cc:1:11: not formatted")]),
    "file_heads": (
        {"include/softgrain/base/a.h": header("softgrain_base_a_h"),
         "bpm/include/softgrain/bpm/a.h": header("softgrain_bpm_a_h"),
         "source/base/a.cc": LICENCE + "#include <softgrain/base/a.h>\n#include <vector>\n"},
        [({"source/base/a.cc": "int a;\n"}, "must hold"),
         ({"script": "#!/bin/sh\ntrue\n"}, "script:1: the first line"),
         ({"include/softgrain/base/a.h": header("softgrain_base_b_h")}, "must be softgrain_base_a_h"),
         ({"include/softgrain/base/a.h": LICENCE + "#pragma once\n"}, "must be softgrain_base_a_h"),
         ({"include/softgrain/base/a.h": LICENCE}, "must be softgrain_base_a_h"),
         ({"include/softgrain/base/a.h": header("softgrain_base_a_h"),
           "source/base/a.cc": LICENCE + "#include <vector>\n"},
          "does not include its own header softgrain/base/a.h")]),
    "leftovers": (
        {"a.md": "See <https://example.org/home/page> and /usr/share/doc.\n", "a.h": "int a;\n" * 500},
        [({"a.h": "// TO" + "DO: later\n"}, "do it, or describe"),
         ({"CMakeLists.txt": "# FIX" + "ME\n"}, "do it, or describe"),
         ({"a.prm": "set Folder = /ho" + "me/someone/data\n"}, "a path of one machine"),
         ({"a.md": "cd /wo" + "rk/main\n"}, "a path of one machine"),
         ({"a.cc": "<" * 7 + " ours\n"}, "conflict marker"),
         ({"a.h": "int a;\n" * 501}, "501 lines, at most 500")]),
    "documentation": (
        {"doc/a.md": "# One `two`\n[b](b.md#what-it-is) [self](#one-two) <https://example.org> `gallery/a.prm` FILE.prm\n",
         "doc/b.md": "## What it is\n", "parameters/gallery/a.prm": "", "a.h": "/// @cite someone1999, eq. (1)\n",
         "doc/references.bib": "@article{someone1999,\n}\n", "doc/a.png": "",
         "doc/gallery.md": "| ![](a.png) | `a.prm`: a scene |\n"},
        [({"a.md": "[b](b.md)\n"}, "link to nothing: b.md"),
         ({"a.md": "![picture](doc/b.png)\n"}, "link to nothing: doc/b.png"),
         ({"a.md": "[b](b.md#there)\n", "b.md": "# Here\n"}, "no heading #there"),
         ({"a.md": "`softgrain run gallery/gone.prm`\n"}, "no such parameter file: gallery/gone.prm"),
         ({"a.md": "```\nsoftgrain run gone.prm\n```\n", "parameters/begone.prm": ""}, "no such parameter file: gone.prm"),
         ({"parameters/gallery/new.prm": "", "doc/gallery.md": "`new.prm` in a line of text\n"}, "new.prm has no row"),
         ({"a.h": "/// @cite nobody2000\n"}, "not in doc/references.bib: nobody2000")]),
    "plain_words": (
        {"a.md": "A sentence of words. " * 30 + "\n\n| " + "cell " * 50 + "|\n\n```\n" + "word " * 50 + "\n```\n",
         "include/softgrain/base/a.h": "/// The same polygon with shorter edges.\nint a; ///< of the first body\n"
                                       "/**\n * @brief Whether it is.\n */\nint b;\n"},
        [({"a.md": "One " + "word " * 40 + "too many.\n"}, "a.md:1: 43 words in a sentence"),
         ({"a.md": "Short.\n- A `name` " + "word " * 20 + "\n  goes on " + "word " * 20 + "\n"}, "a.md:2: 44 words"),
         ({"include/softgrain/base/a.h": "/// Of the first body [m].\nint a;\n"}, "a.h:1: a comment that begins with 'Of'"),
         ({"include/softgrain/base/a.h": "int a;\n/// The same in space.\nint b;\n"}, "begins with 'The same in'"),
         ({"bpm/include/softgrain/bpm/a.h": "int a; ///< Of a body\n"}, "begins with 'Of'"),
         ({"include/softgrain/base/a.h": "/**\n * @brief From here to there.\n */\nint a;\n"}, "begins with 'From'")]),
    "python_types": (
        {"python/pyproject.toml": "[tool.mypy]\nfiles = [\"*.py\"]\ncheck_untyped_defs = true\n", "python/a.py": "def f(x: int) -> int:\n    return x\n"},
        [({"python/pyproject.toml": "[tool.mypy]\nfiles = [\"*.py\"]\ncheck_untyped_defs = true\n", "python/a.py": "def f():\n    return 1 + ''\n"},
          "a.py:2: error")]),
    "tests": (
        {**LISTS, "tests/base/a.cc": "", "tests/base/a.output": "1\n", "tests/base/a.threads=1.output": "1\n"},
        [({**LISTS, "tests/base/a.cc": ""}, "no a.output beside it"),
         ({**LISTS, "tests/base/a.output": "1\n"}, "there is no a.cc"),
         ({**LISTS, "tests/base/a.cc": "", "tests/base/a.output": ""}, "expects nothing"),
         ({**LISTS, "tests/base/a.cc": "", "tests/base/a.output": "# tolerance: 1.1 1e-3\n2\n"},
          "the tolerance 1.1 lets 2 be anything"),
         ({**LISTS, "tests/base/a.cc": "", "tests/base/a.output": "# tolerance of column 2: 1e-9 1\nratio 2\n"},
          "the tolerance 1 lets 2 be anything"),
         ({**LISTS, "tests/base/a.cc": "", "tests/base/a.output": "depth 3e-9, momentum below 1e-12, zero 1e-17\n"},
          "the tolerance 1e-09 lets 3e-9 be anything"),
         ({**LISTS, "tests/lost/a.cc": ""}, "tests/lost: nobody runs it")]),
    "scripts": (
        {"a.py": "print(1)\n", "a.sh": "#!/bin/sh\necho 1\n", "python/softgrain/a.py": "from .b import c\nfrom . import d\n",
         "python/softgrain/b.py": "", "python/softgrain/d.py": "from .figures import e\n", "python/softgrain/figures/e.py": "from .. import b\n"},
        [({"a.py": "def f(:\n"}, "a.py:1"), ({"run": "#!/bin/sh\nif true; then\n"}, "run: line"),
         ({"run": "#!/usr/bin/env python3\nprint(\n"}, "run:2" if sys.version_info < (3, 10) else "run:"),
         ({"not_executable": "#!/bin/sh\ntrue\n"}, "cannot be executed"),
         ({"python/softgrain/a.py": "from .b import c\n", "python/softgrain/b.py": "def f():\n    from . import a\n"},
          "python/softgrain/a.py: imports itself by way of python/softgrain/b.py"),
         ({"python/a.py": "a = 1\n# " + "word " * 20 + "\n"}, "python/a.py:2: 102 columns")]),
}


def run(check, sample):
    """Status and output of the check on a folder that holds the sample."""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in sample.items():
            path = Path(folder) / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
            if text.startswith("#!") and name != "not_executable":
                path.chmod(0o755)
        program = [sys.executable, str(ROOT / "contrib/checks" / f"{check}.py"), "--root", folder]
        done = subprocess.run(program, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr


def main(check):
    good, bad = SAMPLES[check]
    status, said = run(check, good)
    wrong = [f"refuses the good sample:\n{said}"] if status != 0 else []
    for sample, expected in bad:
        status, said = run(check, sample)
        if status == 0 and said.startswith("not checked"):
            continue  # this system has not what the check needs
        if status != 1 or expected not in said:
            wrong.append(f"on {sorted(sample)} it should end with 1 and say '{expected}', not {status} and:\n{said}")
    print("\n".join(wrong) or f"{check}: {len(bad)} bad samples found out")
    return 1 if wrong else 0


sys.exit(main(sys.argv[1]))
