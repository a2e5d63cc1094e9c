# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""pip install . : the compiled module is built by CMake; nothing is downloaded.

CMAKE_ARGS has further options, such as those for a library that is installed already:
-DTUBULAR_MESHING_USE_INSTALLED=ON -DTubular_meshing_DIR=<folder of Tubular_meshingConfig.cmake>
or -DTUBULAR_MESHING_WITH_VIEWER=ON, for pages of reports with the mesh in 3D, which npm downloads the parts for.
"""

import os
import pathlib
import re
import shlex
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parent


class BuildByCMake(build_ext):
    def build_extension(self, extension):
        build = pathlib.Path(self.build_temp).resolve()
        build.mkdir(parents=True, exist_ok=True)
        target = pathlib.Path(self.get_ext_fullpath(extension.name)).resolve()
        options = [f"-DTUBULAR_MESHING_BUILD_{part}=OFF" for part in ("EXAMPLES", "TESTS", "BENCHMARKS")]
        options += [
            "-DTUBULAR_MESHING_BUILD_PYTHON=ON",
            f"-DTUBULAR_MESHING_PYTHON={sys.executable}",
            "-DCMAKE_BUILD_TYPE=Release",
            "-DBUILD_SHARED_LIBS=OFF",
            "-DTUBULAR_MESHING_WITH_VIEWER=OFF",
        ]
        options += shlex.split(os.environ.get("CMAKE_ARGS", ""))
        jobs = os.environ.get("CMAKE_BUILD_PARALLEL_LEVEL", "1")
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *options], check=True)
        subprocess.run(
            ["cmake", "--build", str(build), "--target", "tubular_meshing_python", "--parallel", jobs], check=True
        )
        built = next((build / "python" / "tubular_meshing").glob("_core*.so"))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(str(built), str(target))


def version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"VERSION (\d+\.\d+\.\d+)\n", text).group(1)


setup(
    version=version(),
    ext_modules=[Extension("tubular_meshing._core", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={"build": {"build_base": "build-python"}},  # build/ is CMake's
)
