# SPDX-License-Identifier: LGPL-2.1-or-later
"""
A copied source folder finds in ccache what was compiled in the first one: a small project with the settings of ours, a header
in its own folder and an absolute path to it, built in two places. Arguments: CMAKE ROOT WORK.
"""

import os
import re
import shutil
import subprocess
import sys

CMAKE, ROOT, WORK = sys.argv[1], os.path.abspath(sys.argv[2]), os.path.abspath(sys.argv[3])
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(small CXX)
include({root}/cmake/compile_time.cmake)
add_library(small STATIC small.cc)
target_include_directories(small PRIVATE ${{PROJECT_SOURCE_DIR}}/include)
"""


def hits(environment):
    done = subprocess.run(["ccache", "--print-stats"], env=environment, capture_output=True, text=True, check=True)
    found = {name: int(value) for name, value in re.findall(r"^(\w+)\s+(\d+)$", done.stdout, re.M)}
    return found["direct_cache_hit"] + found["preprocessed_cache_hit"], found["cache_miss"]


def build(folder, environment):
    os.makedirs(f"{folder}/include")
    for name, text in (("CMakeLists.txt", PROJECT.format(root=ROOT)), ("include/small.h", "#pragma once\nint small();\n"),
                       ("small.cc", '#include "small.h"\nint small() { return 1; }\n')):
        with open(f"{folder}/{name}", "w", encoding="utf-8") as file:
            file.write(text)
    for words in (("-S", folder, "-B", f"{folder}/build", "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"), ("--build", f"{folder}/build")):
        done = subprocess.run([CMAKE, *words], env=environment, capture_output=True, text=True, check=False)
        if done.returncode != 0:
            sys.exit(done.stdout + done.stderr)


def main():
    if not shutil.which("ccache"):
        print("ccache is not there")
        return
    shutil.rmtree(WORK, ignore_errors=True)
    environment = {name: value for name, value in os.environ.items() if not name.startswith("CCACHE_")}
    environment["CCACHE_DIR"] = f"{WORK}/cache"
    found = []
    for place in ("here", "far/away"):
        build(f"{WORK}/{place}", environment)
        found.append(hits(environment))
    if found != [(0, 1), (1, 1)]:
        sys.exit(f"(found, compiled) after the first and the second folder: {found}")
    print("the copy compiled nothing")


main()
