#!/usr/bin/env bash
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing (Debian, as root or with sudo), builds the program, the library and the Python package, and
# makes packages of them in the build directory: .deb, and an archive that runs where it is unpacked.
#
#   scripts/package.sh [option of cpack...]      e.g. -G DEB
#
# TUBULAR_MESHING_BUILD_DIR names another build directory than build/.

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install_packages "${library_packages[@]}" "${example_packages[@]}" "${python_packages[@]}" dpkg-dev file
is_configured || configure -DTUBULAR_MESHING_BUILD_TESTS=OFF -DTUBULAR_MESHING_BUILD_PYTHON=ON
build --target all

cd "$build_dir"
cpack "$@"
