# Recipe for Spack (https://spack.readthedocs.io): the particle method, comparisons and reports; with +openfoam also the
# second method. It names the archive and the checksum that tools/recipes.sh puts in, because no release has been
# published: that script packs the checkout's last commit and writes a repository for Spack beside it.
#
#   tools/recipes.sh ~/twinwake_recipes && spack repo add ~/twinwake_recipes/spack && spack install twinwake
from spack.package import *


class Twinwake(CMakePackage):
    """Drag, lift and splash of a hull in water, by two methods side by side: delta-SPH particles and OpenFOAM's interFoam."""

    url = "file://@FOLDER@/@ARCHIVE@"

    license("BSD-3-Clause")

    version("@VERSION@", sha256="@SHA256@")

    variant("mpi", default=True, description="runs that several processes share")
    variant("step", default=True, description="hulls from STEP and IGES (Open CASCADE)")
    variant("openfoam", default=False, description="the second method, interFoam")

    depends_on("c", type="build")
    depends_on("cxx", type="build")
    depends_on("cmake@3.22:", type="build")
    depends_on("eigen@3.4:")
    depends_on("fmt@9:")
    depends_on("tomlplusplus@3.2:", type=("build", "link"))
    depends_on("cli11@2.1:", type=("build", "link"))
    depends_on("nlohmann-json@3.11:", type=("build", "link"))
    depends_on("boost@1.74:")
    depends_on("openssl@3:")
    depends_on("zlib-api")
    depends_on("egl")
    depends_on("hdf5@1.10:~mpi")
    depends_on("vtk@9.1:~mpi")
    depends_on("mpi", when="+mpi")
    depends_on("opencascade@7.6:", when="+step")
    depends_on("openfoam@2206:", type="run", when="+openfoam")

    conflicts("%gcc@:11", msg="C++20 as GCC 12 has it")

    def cmake_args(self):
        return [
            self.define("TWINWAKE_TESTS", False),
            self.define_from_variant("TWINWAKE_MPI", "mpi"),
            self.define_from_variant("TWINWAKE_OCCT", "step"),
        ]

    @run_after("install")
    @on_package_attributes(run_tests=True)
    def says_its_version(self):
        Executable(self.prefix.bin.twinwake)("--version")
