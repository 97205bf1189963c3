# SPDX-License-Identifier: LGPL-2.1-or-later
"""
Programs start without Gmsh and OpenCASCADE: the libraries of these names that the dynamic linker finds are the stand-ins, and
whoever calls one of their functions is told so in one line. Arguments: PROGRAM FOLDER.
"""
import re
import subprocess
import sys


def main():
    program, folder = sys.argv[1:]
    listed = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    paths = dict(re.findall(r"^\s*(\S+) => (\S+) \(0x", listed, re.MULTILINE))
    stand_ins = {name: path for name, path in paths.items() if re.match(r"lib(gmsh|TK\w+)\.so", name)}
    assert stand_ins, listed
    for name, path in stand_ins.items():
        assert path == f"{folder}/{name}", f"{name} is taken from {path}"
    called = 0
    for path in stand_ins.values():
        symbols = subprocess.run(["nm", "--dynamic", "--defined-only", path], check=True, capture_output=True, text=True).stdout
        function = re.search(r" [Tt] (_Z\S+)$", symbols, re.MULTILINE)
        if function:
            done = subprocess.run([sys.executable, "-c", "import ctypes, sys; ctypes.CDLL(sys.argv[1])[sys.argv[2]]()", path,
                                   function[1]], check=False, capture_output=True, text=True)
            assert done.returncode == -6 and "starts without Gmsh and OpenCASCADE" in done.stderr, (path, done)
            called += 1
    assert called, "no stand-in has a function"
    print(f"{len(stand_ins)} libraries are stood in for, {called} say so when they are called")


main()
