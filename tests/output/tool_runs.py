# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What the tests of the Python tools share: the first argument is the folder of the tools, and no test needs a display.
Import it before anything of matplotlib or of the tools.
"""

import contextlib
import importlib
import io
import os
import sys

TOOLS = os.path.abspath(sys.argv[1])
sys.path.insert(0, TOOLS)
sys.dont_write_bytecode = True

import matplotlib  # noqa: E402

matplotlib.use("Agg")

from softgrain import command  # noqa: E402


def run(tool, *arguments):
    """
    Runs a tool within this process (loading its libraries anew for every case would take most of the time); returns
    (exit code, what is printed, error lines).
    """
    module = importlib.import_module(tool[:-3])
    out, errors, code = io.StringIO(), io.StringIO(), 0
    old_arguments, sys.argv = sys.argv, [tool, *arguments]
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(errors):
            command.run_tool(module.main)
    except SystemExit as end:
        code = end.code
    finally:
        sys.argv = old_arguments
    return code, out.getvalue(), errors.getvalue()
