# SPDX-License-Identifier: BSD-3-Clause
"""What pip and build call at the top of the tree: setuptools in adapters/python, where setup.py stands."""

import gzip
import os
import pathlib
import subprocess
import tempfile

from setuptools import build_meta

here = pathlib.Path(__file__).resolve().parent
os.chdir(here)

build_wheel = build_meta.build_wheel
get_requires_for_build_wheel = build_meta.get_requires_for_build_wheel
prepare_metadata_for_build_wheel = build_meta.prepare_metadata_for_build_wheel


def build_sdist(sdist_directory, config_settings=None):
    """The whole tree of the commit, as git archives it, for a wheel has the library in it; the same bytes each time."""
    with tempfile.TemporaryDirectory() as folder:
        metadata = pathlib.Path(folder, prepare_metadata_for_build_wheel(folder), "METADATA").read_bytes()
        told = pathlib.Path(folder, "PKG-INFO")
        told.write_bytes(metadata)
        version = next(line.split()[1].decode() for line in metadata.splitlines() if line.startswith(b"Version: "))
        name = f"grit_sand-{version}"
        try:
            tree = subprocess.check_output(["git", "archive", f"--prefix={name}/", f"--add-file={told}", "HEAD"], cwd=here.parent.parent)
        except (OSError, subprocess.CalledProcessError) as error:
            raise SystemExit("Grit: a source distribution is made by git, in a clone") from error
    file = pathlib.Path(sdist_directory, f"{name}.tar.gz")
    file.write_bytes(gzip.compress(tree, mtime=0))
    return file.name
