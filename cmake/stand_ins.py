#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Makes libraries that stand in, in a folder of their own, for those that deal.II brings and softgrain never calls: Gmsh and
OpenCASCADE. They have the same names and the few symbols that deal.II wants, so the dynamic linker loads neither the real ones
nor the hundred libraries behind them, which is more than half of what a start costs. Whoever calls one all the same is told so.
"""
import argparse
import pathlib
import re
import subprocess
import sys

NEVER_CALLED = re.compile(r"lib(gmsh|TK\w+)\.so")
MESSAGE = "softgrain starts without Gmsh and OpenCASCADE; with them where it is built with -DSOFTGRAIN_STAND_INS=OFF"


def output(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


class Library:
    """What a library defines (name: kind and size), what it wants, the libraries that it names, and whether it says where they are."""

    def __init__(self, path):
        self.defined, self.wanted = {}, set()
        for line in output("nm", "--dynamic", "--print-size", path).splitlines():
            *numbers, kind, name = line.split()
            if kind == "U":
                self.wanted.add(name)
            elif kind not in "wv":
                self.defined[name] = kind, int(numbers[1], 16) if len(numbers) == 2 else 0
        dynamic = output("readelf", "--dynamic", "--wide", path)
        self.needed = re.findall(r"\(NEEDED\).*\[(.*)\]", dynamic)
        self.has_path = re.search(r"\((RPATH|RUNPATH)\)", dynamic) is not None


def loaded(library):
    """Path of every library that comes with this one, by its name."""
    found = re.findall(r"^\s*(?:(\S+) => )?(/\S+) \(0x", output("ldd", library), re.MULTILINE)
    return {name or pathlib.Path(path).name: path for name, path in found}


def source(symbols):
    """C source of a library with these symbols; data are zero."""
    lines = ["#include <stdio.h>", "#include <stdlib.h>", "static void stand_in(void)",
             "{", f'  fputs("{MESSAGE}\\n", stderr);', "  abort();", "}", "char stand_in_mark;"]
    for number, (name, (kind, size)) in enumerate(sorted(symbols.items())):
        if kind in "TWi":
            lines.append(f'void symbol_{number}(void) __asm__("{name}") __attribute__((alias("stand_in")));')
        else:
            lines.append(f'char symbol_{number}[{max(size, 16)}] __asm__("{name}") __attribute__((aligned(16)));')
    return "\n".join(lines) + "\n"


def stand_ins(deal_ii):
    """Symbols of every stand-in, by the name of the library; none where nothing can be left out."""
    paths = loaded(deal_ii)
    kept, direct, waiting = {deal_ii.name: Library(deal_ii)}, set(), [deal_ii.name]
    while waiting:
        user = kept[waiting.pop()]
        for name in user.needed:
            if NEVER_CALLED.match(name):
                if user.has_path:
                    sys.exit("no stand-ins, since what uses Gmsh or OpenCASCADE has a search path of its own, which comes first")
                direct.add(name)
            elif name not in kept:
                kept[name] = Library(paths[name])
                waiting.append(name)
    defined = {bare(symbol) for library in kept.values() for symbol in library.defined}
    wanted = {bare(symbol) for library in kept.values() for symbol in library.wanted} - defined
    symbols = {}
    for name in sorted(direct):
        there = Library(paths[name]).defined
        symbols[name] = {symbol: there[symbol] for symbol in there if symbol in wanted}
        wanted -= symbols[name].keys()
    return symbols


def bare(symbol):
    return symbol.split("@")[0]


def refused(deal_ii, folder=None):
    """What the dynamic linker says that it does not find, with or without the stand-ins."""
    variables = {"LC_ALL": "C", "PATH": "/usr/bin:/bin"} | ({"LD_LIBRARY_PATH": str(folder)} if folder else {})
    done = subprocess.run(["ldd", "-r", str(deal_ii)], check=False, capture_output=True, text=True, env=variables)
    return {line.split("(")[0] for line in (done.stdout + done.stderr).splitlines() if "undefined" in line or "not found" in line}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("deal_ii", type=pathlib.Path, help="its library")
    parser.add_argument("folder", type=pathlib.Path, help="where the stand-ins are put")
    parser.add_argument("--compiler", default="cc")
    arguments = parser.parse_args()
    deal_ii, folder = arguments.deal_ii.resolve(), arguments.folder
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    for name, symbols in stand_ins(deal_ii).items():
        subprocess.run([arguments.compiler, "-shared", "-fPIC", "-O1", "-s", f"-Wl,-soname,{name}", "-o", str(folder / name),
                        "-x", "c", "-"], input=source(symbols), text=True, check=True)
    missing = refused(deal_ii, folder) - refused(deal_ii)
    if missing:
        for made in folder.iterdir():
            made.unlink()
        sys.exit("no stand-ins, since these would be missing: " + "; ".join(sorted(missing)[:3]))


if __name__ == "__main__":
    main()
