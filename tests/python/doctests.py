# SPDX-License-Identifier: LGPL-2.1-or-later
"""
The examples in the package, and those of doc/python.md, give what they say. Arguments: PYTHON_DIR WORK EXAMPLE PROGRAM.

`example` is the run of example.prm, `example_scene` that file, `scratch` an empty folder.
"""

import doctest
import importlib
import os
import pkgutil
import shutil
import sys

import common
import numpy as np
import softgrain

FLAGS = doctest.NORMALIZE_WHITESPACE | doctest.ELLIPSIS
OPTIONAL = ("pandas",)  # what a module may need that nobody must have


def known():
    return {"np": np, "softgrain": softgrain, "example": softgrain.open(common.EXAMPLE), "example_scene": common.SCENE,
            "scratch": common.WORK}


def main():
    shutil.copy(common.SCENE, "scene.prm")
    shutil.copytree(common.EXAMPLE, "output/example")
    names = [f"softgrain.{module.name}" for module in pkgutil.iter_modules(softgrain.__path__)]
    failed = attempted = 0
    for name in ["softgrain", *names]:
        try:
            module = importlib.import_module(name)
        except ModuleNotFoundError as missing:
            if missing.name not in OPTIONAL:
                raise
            print(f"{name}: not checked without {missing.name}")
            continue
        result = doctest.testmod(module, extraglobs=known(), optionflags=FLAGS)
        failed, attempted = failed + result.failed, attempted + result.attempted
    page = os.path.join(common.PYTHON, os.pardir, "doc", "python.md")
    result = doctest.testfile(page, module_relative=False, globs=known(), optionflags=FLAGS)
    failed, attempted = failed + result.failed, attempted + result.attempted
    print(f"{attempted} examples, {failed} failed")
    return failed > 0 or attempted < 60


sys.exit(main())
