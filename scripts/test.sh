#!/usr/bin/env bash
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing (Debian, as root or with sudo), builds everything (each header alone, examples, tests,
# benchmarks, the Python package) and runs all tests; ctest's closing lines come last.
#
#   scripts/test.sh [option of cmake...]      e.g. -DCGAL_DIR=… for another CGAL
#
# TUBULAR_MESHING_BUILD_DIR names another build directory than build/.

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_packages "${library_packages[@]}" "${example_packages[@]}" "${python_packages[@]}" \
  "${test_packages[@]}"
configure -DTUBULAR_MESHING_BUILD_EXAMPLES=ON -DTUBULAR_MESHING_BUILD_TESTS=ON -DTUBULAR_MESHING_BUILD_BENCHMARKS=ON \
  -DTUBULAR_MESHING_BUILD_PYTHON=ON "$@"
build --target all

cd "$build_dir"
ctest --output-on-failure --no-tests=error --parallel "$(number_of_jobs)"
