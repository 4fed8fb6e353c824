# SPDX-License-Identifier: BSD-3-Clause
"""pip install --no-build-isolation --no-deps .    at the top of the tree, in a virtual environment that sees NumPy

CMake builds the module out of the source tree that this folder stands in, in build/python there, or in a
temporary folder where that cannot be written."""

import atexit
import importlib.metadata
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from wheel.bdist_wheel import bdist_wheel

here = pathlib.Path(__file__).resolve().parent
root = here.parent.parent
version = ".".join(re.findall(r"#define GRIT_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)",
                              (root / "include/grit/version.h").read_text()))


def folder_to_build_in():
    folder = root / "build" / "python"
    try:
        (folder / "info").mkdir(parents=True, exist_ok=True)
        tempfile.TemporaryFile(dir=folder / "info").close()
    except OSError:
        folder = pathlib.Path(tempfile.mkdtemp(prefix="grit-python-"))
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
        (folder / "info").mkdir()
    return folder


work = folder_to_build_in()


class BuildWithCMake(build_ext):
    def build_extension(self, extension):
        generator = ["-G", "Ninja"] if shutil.which("ninja") else []
        off = [f"-DGRIT_BUILD_{part}=OFF" for part in ("TESTS", "CLI", "MPM", "FORTRAN")]
        subprocess.check_call(["cmake", "-S", root, "-B", work, *generator, *off,
                               "-DCMAKE_BUILD_TYPE=Release", "-DGRIT_BUILD_PYTHON=ON",
                               # The C++ library of the compiler goes into the module: the wheel needs that of C only.
                               "-DCMAKE_MODULE_LINKER_FLAGS=-static-libstdc++ -static-libgcc",
                               f"-DPython_EXECUTABLE={sys.executable}"])
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count() or 1))
        subprocess.check_call(["cmake", "--build", work, "--target", "grit_python",
                               "--parallel", jobs])
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(work / "adapters/python/grit" / target.name, target)


class TaggedWheel(bdist_wheel):
    """The tag says which C library the module needs: the highest version among the symbols that it asks for. What is
    compiled in has its licences beside it."""

    def egg2dist(self, egginfo_path, distinfo_path):
        super().egg2dist(egginfo_path, distinfo_path)
        for licence in ("LICENSE", "packages/third_party.txt"):
            shutil.copy2(root / licence, distinfo_path)

    def get_tag(self):
        python, abi, platform = super().get_tag()
        modules = list(pathlib.Path(self.bdist_dir).rglob("_grit*.so"))
        if platform.startswith("linux_") and modules:
            needs = subprocess.check_output(["objdump", "-T", modules[0]], text=True)
            minor = max(int(minor) for minor in re.findall(r"GLIBC_2\.(\d+)", needs))
            foreign = set(re.findall(r"(?:GLIBCXX|CXXABI|GCC)_[\d.]+", needs))
            if not foreign:
                platform = platform.replace("linux_", f"manylinux_2_{minor}_")
        return python, abi, platform


def numpy_needed():
    """pybind11 knows NumPy 2 from 2.12 on; modules made with an older one misread what NumPy 2 tells of arrays."""
    try:
        told = subprocess.check_output(["pkg-config", "--modversion", "pybind11"], text=True, stderr=subprocess.DEVNULL)
    except (OSError, subprocess.CalledProcessError):
        try:
            told = importlib.metadata.version("pybind11")
        except importlib.metadata.PackageNotFoundError:
            told = "0.0"
    return "numpy" if tuple(map(int, told.split(".")[:2])) >= (2, 12) else "numpy<2"


setup(
    name="grit-sand",
    version=version,
    description="Hypoplastic sand and contact at grid nodes",
    long_description=(root / "docs/python.md").read_text(),
    long_description_content_type="text/markdown",
    author="The Grit authors",
    license="BSD-3-Clause",
    classifiers=["Development Status :: 4 - Beta", "Intended Audience :: Science/Research",
                 "Operating System :: POSIX :: Linux", "Programming Language :: C++",
                 "Programming Language :: Python :: 3", "Topic :: Scientific/Engineering"],
    packages=["grit"],
    package_data={"grit": ["*.pyi", "py.typed"]},
    python_requires=">=3.9",
    install_requires=[numpy_needed()],
    ext_modules=[Extension("grit._grit", [])],
    options={"build": {"build_base": str(work / "setup")}, "egg_info": {"egg_base": str(work / "info")}},
    cmdclass={"build_ext": BuildWithCMake, "bdist_wheel": TaggedWheel},
)
