#!/usr/bin/env bash
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Installs what is missing (Debian, as root or with sudo), builds tubular_mesh, and meshes the samples in data/.
#
#   scripts/run.sh [option of tubular_mesh...]
#
# TUBULAR_MESHING_BUILD_DIR names another build directory than build/.

set -euo pipefail
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

# The centerlines of data/NAME.stl are data/NAME_centerlines.*
centerlines_of() {
  local file
  for file in "${1%.*}"_centerlines.{vtk,vtp,msh}; do
    if [ -f "$file" ]; then
      say "$file"
      return
    fi
  done
}

install_packages "${library_packages[@]}" "${example_packages[@]}"
is_configured || configure -DTUBULAR_MESHING_BUILD_TESTS=OFF
build --target tubular_mesh

sample_dir=$build_dir/sample
mkdir -p "$sample_dir"
meshed=0
for surface in "$root_dir"/data/*.stl; do
  [ -f "$surface" ] || continue
  centerlines=$(centerlines_of "$surface")
  [ -n "$centerlines" ] || continue
  name=$(basename "$surface" .stl)
  say
  "$build_dir/examples/Tubular_meshing/tubular_mesh" "$surface" -c "$centerlines" \
    -o "$sample_dir/$name.vtu" --report "$sample_dir/$name.json" "$@"
  say
  say "mesh:   $sample_dir/$name.vtu"
  say "report: $sample_dir/$name.json"
  meshed=$((meshed + 1))
done
[ "$meshed" -gt 0 ] || fail "data/ holds no surface NAME.stl with its NAME_centerlines.vtk"
