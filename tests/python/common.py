# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What the tests of the Python package share. Arguments: PYTHON_DIR WORK EXAMPLE PROGRAM: the folder of the package, a
folder for the test, the output of example.prm, the program.
"""

import os
import shutil
import sys

PYTHON, WORK, EXAMPLE, PROGRAM = map(os.path.abspath, sys.argv[1:5])
SCENE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "example.prm")
sys.path.insert(0, PYTHON)
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "output"))
sys.dont_write_bytecode = True
os.environ["SOFTGRAIN"] = PROGRAM

import matplotlib  # noqa: E402

matplotlib.use("Agg")

shutil.rmtree(WORK, ignore_errors=True)
os.makedirs(WORK)
os.chdir(WORK)
