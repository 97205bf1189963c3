# SPDX-License-Identifier: LGPL-2.1-or-later
"""
What others install: `cmake --install` into an empty folder and the package of `cpack` each hold a program that runs, and all
that a law of one's own needs: the example of that installation is built by find_package(softgrain), examined by the installed
tester, and used in a run. Arguments: BUILD WORK KIND, where KIND is prefix or package.
"""

import os
import shutil
import subprocess
import sys


def call(*words, expect=0, **options):
    done = subprocess.run(list(map(str, words)), capture_output=True, text=True, check=False, **options)
    assert done.returncode == expect, f"{words} ended with {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout + done.stderr


def installed(build):
    call("cmake", "--install", build, "--prefix", os.path.abspath("prefix"))
    return os.path.abspath("prefix")


def unpacked(build):
    """The package, unpacked; what it depends on is looked at."""
    call("cpack", "-B", os.path.abspath("package"), "--config", os.path.join(build, "CPackConfig.cmake"))
    package, = [os.path.join("package", name) for name in os.listdir("package") if name.endswith(".deb")]
    fields = dict(line.split(": ", 1) for line in call("dpkg-deb", "--field", package).splitlines() if ": " in line)
    assert fields["Package"] == "softgrain" and fields["Architecture"] == "amd64", fields
    depends = [item.split()[0] for item in fields["Depends"].split(", ")]
    for name in ("python3", "libc6"):
        assert name in depends, depends
    assert any(name.startswith("libdeal.ii") for name in depends), depends
    assert not any(name.endswith("-dev") for name in depends), depends
    assert "python3-numpy" in fields["Recommends"], fields
    print(f"{os.path.basename(package)}: {os.path.getsize(package) / 2**20:.1f} MiB; needs {fields['Depends']}")
    call("dpkg-deb", "--extract", package, "root")
    # Nothing that apt would not expect: all below /usr, no folder of the machine that built it.
    assert os.listdir("root") == ["usr"], os.listdir("root")
    assert os.path.isdir("root/usr/lib/python3/dist-packages/softgrain")
    return os.path.abspath("root/usr")


def main():
    build, work, kind = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2]), sys.argv[3]
    if kind == "package" and not (shutil.which("dpkg-deb") and shutil.which("dpkg-shlibdeps")):
        print("dpkg-deb and dpkg-shlibdeps (package dpkg-dev) are not both there")
        sys.exit(77)
    shutil.rmtree(work, ignore_errors=True)
    os.makedirs(work)
    os.chdir(work)
    prefix = installed(build) if kind == "prefix" else unpacked(build)
    share = os.path.join(prefix, "share")
    program = os.path.join(prefix, "bin/softgrain")
    for path in ("man/man1/softgrain.1", "bash-completion/completions/softgrain", "doc/softgrain/index.md",
                 "softgrain/third-party/plotly-basic.min.js", "softgrain/parameters/gallery/two_disks.prm"):
        assert os.path.isfile(os.path.join(share, path)), path
    version = call(program, "--version").split()[1]
    made = os.path.join(build, "lib/softgrain-stand-ins")
    if os.path.isdir(made) and os.listdir(made):
        for line in call("ldd", program).splitlines():
            if line.split()[0] in os.listdir(made):
                place = os.path.realpath(line.split()[2])
                assert place.startswith(os.path.realpath(prefix) + "/") and "/softgrain-stand-ins/" in place, line

    # The example as a user copies it; another version or another build type is refused.
    shutil.copytree(os.path.join(share, "softgrain/examples/custom_law"), "law")
    configure = ["cmake", "-S", "law", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={prefix}"]
    print(call(*configure, "-B", "law/build").splitlines()[-1])
    with open("law/build/CMakeCache.txt", encoding="utf-8") as file:
        assert f"softgrain_DIR:PATH={prefix}/" in file.read()
    with open(os.path.join(build, "CMakeCache.txt"), encoding="utf-8") as file:
        other = "Debug" if "CMAKE_BUILD_TYPE:STRING=Release" in file.read() else "Release"
    assert "softgrain was built with CMAKE_BUILD_TYPE" in call(*configure, "-B", "other", f"-DCMAKE_BUILD_TYPE={other}", expect=1)
    with open("law/CMakeLists.txt", encoding="utf-8") as file:
        text = file.read()
    os.mkdir("future")
    with open("future/CMakeLists.txt", "w", encoding="utf-8") as file:
        file.write(text.replace("softgrain 0.2", "softgrain 99"))
    assert f"version: {version}" in call("cmake", "-S", "future", "-B", "future/build", f"-DCMAKE_PREFIX_PATH={prefix}", expect=1)

    call("cmake", "--build", "law/build")
    library = os.path.abspath("law/build/libcustom_law.so")
    said = call(os.path.join(prefix, "bin/softgrain-law-tester"), library)
    assert "laws in the library: fung" in said and said.endswith("every law holds every property: yes\n"), said
    scene = os.path.join(share, "softgrain/parameters/gallery/two_disks.prm")
    sets = [f"Additional shared libraries={library}", "Materials/gel/Law=fung", "Stop/End time=1e-4"]
    call(program, "run", scene, "--output", "out", *[word for one in sets for word in ("--set", one)])
    with open("out/parameters.prm", encoding="utf-8") as file:
        assert "fung" in file.read()
    print(f"{kind}: softgrain {version} runs, finds its files, and takes a law that was built against it")


main()
