#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Makes a wheel of the Python package for `pip install`: with the program of an installation in it, or for analysis alone."""
import argparse
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
# A wheel with a program in it is for one kind of machine, but for every Python 3.
SETUP = """
from setuptools import setup
from wheel.bdist_wheel import bdist_wheel


class OfMachine(bdist_wheel):
    def finalize_options(self):
        super().finalize_options()
        self.root_is_pure = False

    def get_tag(self):
        return "py3", "none", "{platform}"


setup(cmdclass={{"bdist_wheel": OfMachine}})
"""


def copy_program(prefix, target):
    """Program and library of an installation, and the libraries that stand in for those it does not need."""
    libraries = sorted(prefix.glob("lib*/libsoftgrain*")) + sorted(prefix.glob("lib*/*/libsoftgrain*"))
    program = prefix / "bin/softgrain"
    if not program.is_file() or not libraries:
        sys.exit(f"wheel: {prefix} is no installation of softgrain: cmake --install build/release --prefix {prefix}")
    stand_ins = sorted(prefix.glob("lib*/softgrain-stand-ins/*")) + sorted(prefix.glob("lib*/*/softgrain-stand-ins/*"))
    for path in (program, *libraries, *stand_ins):
        place = target / path.relative_to(prefix)
        place.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(path, place)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("prefix", nargs="?", type=pathlib.Path, metavar="PREFIX",
                        help="folder of `cmake --install BUILD --prefix PREFIX`; without it the wheel has no program")
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("dist"), metavar="DIR", help="default: %(default)s")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder) / "python"
        shutil.copytree(ROOT / "python", source, ignore=shutil.ignore_patterns("__pycache__", "build", "*.egg-info"))
        inside = source / "softgrain/program"
        tools = inside / "share/softgrain/python"
        tools.mkdir(parents=True)
        for tool in source.glob("*.py"):
            shutil.move(str(tool), tools / tool.name)
        shutil.copytree(ROOT / "contrib/third-party", inside / "share/softgrain/third-party")
        if arguments.prefix:
            copy_program(arguments.prefix.resolve(), inside)
            platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
            (source / "setup.py").write_text(SETUP.format(platform=platform), encoding="utf-8")
        arguments.output.mkdir(parents=True, exist_ok=True)
        done = subprocess.run([sys.executable, "-m", "pip", "wheel", "-q", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir",
                               str(arguments.output), str(source)], check=False)
        if done.returncode:
            sys.exit("wheel: pip could not make it; Debian's packages python3-pip, python3-setuptools and python3-wheel are needed")
    print(max(arguments.output.glob("softgrain-*.whl"), key=lambda path: path.stat().st_mtime))


if __name__ == "__main__":
    main()
