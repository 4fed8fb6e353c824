# SPDX-License-Identifier: BSD-3-Clause
"""What pip calls at the top of the tree: setuptools in adapters/python, where setup.py stands."""

import os
import pathlib

from setuptools import build_meta

os.chdir(pathlib.Path(__file__).resolve().parent)

build_wheel = build_meta.build_wheel
get_requires_for_build_wheel = build_meta.get_requires_for_build_wheel
prepare_metadata_for_build_wheel = build_meta.prepare_metadata_for_build_wheel
