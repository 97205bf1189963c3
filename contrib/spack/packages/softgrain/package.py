# SPDX-License-Identifier: LGPL-2.1-or-later
"""Recipe of Spack. It builds the last commit of the clone that it lies in."""
from pathlib import Path

from spack.package import *


class Softgrain(CMakePackage):
    """Mechanics of packings of soft particles: implicit material points and bonded particles on one solver of
    contact dynamics."""

    git = f"file://{Path(__file__).resolve().parents[4]}"

    license("LGPL-2.1-or-later")

    version("main", branch="main")

    variant("native", default=True, description="compile for the processor of this machine")
    variant("trilinos", default=True, description="linear solvers of Trilinos")
    variant("pictures", default=True, description="Python packages that draw")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.25:", type="build")
    depends_on("ninja", type="build")
    depends_on("dealii@9.4:9.7+mpi+hdf5+threads+muparser")
    depends_on("dealii+trilinos", when="+trilinos")
    depends_on("eigen@3.4:3")
    depends_on("cli11", type="build")
    depends_on("nlohmann-json", type="build")
    depends_on("suite-sparse")
    depends_on("muparser")
    depends_on("python@3.9:", type=("build", "run"))
    with when("+pictures"):
        depends_on("py-numpy", type="run")
        depends_on("py-h5py", type="run")
        depends_on("py-matplotlib", type="run")

    generator("ninja")

    def cmake_args(self):
        return [
            self.define_from_variant("SOFTGRAIN_NATIVE", "native"),
            self.define_from_variant("SOFTGRAIN_TRILINOS", "trilinos"),
            self.define("BUILD_TESTING", False),
            self.define("CMAKE_BUILD_TYPE", "Release"),
        ]
