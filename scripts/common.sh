# shellcheck shell=bash disable=SC2034
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What run.sh and test.sh share; sourced, not run.

root_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build_dir=${TUBULAR_MESHING_BUILD_DIR:-$root_dir/build}

library_packages=(g++ cmake ninja-build libcgal-dev libeigen3-dev libtbb-dev zlib1g-dev liblzma-dev libpugixml-dev
  libtet1.5-dev liblemon-dev libhdf5-dev libcgns-dev libexodusii-dev libmetis-dev)
example_packages=(libcli11-dev nlohmann-json3-dev)
python_packages=(pybind11-dev python3-dev python3-numpy)
test_packages=(libgtest-dev libbenchmark-dev clang libclang-rt-dev python3-pytest chromium) # Clang: for the fuzz tests alone
# For pages with the mesh in 3D; Node.js may have come with an npm that is no Debian package.
command -v npm >/dev/null || example_packages+=(npm)

say() { printf '%s\n' "$*"; }
fail() {
  printf 'error: %s\n' "$*" >&2
  exit 1
}

# run_as_root COMMAND...: with sudo unless root already; sudo asks for a password only where somebody can answer.
run_as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif [ -t 0 ]; then
    sudo "$@"
  else
    sudo -n "$@"
  fi
}

# install_packages NAME...: those of the Debian packages that are not installed yet.
install_packages() {
  local name missing=()
  if ! command -v dpkg-query >/dev/null; then
    say "This system has no Debian packages: CMake will say what is missing of: $*"
    return
  fi
  for name in "$@"; do
    dpkg-query -W -f '${Status}\n' "$name" 2>/dev/null | grep -q '^install ok installed$' || missing+=("$name")
  done
  [ ${#missing[@]} -gt 0 ] || return 0

  if [ "$(id -u)" -ne 0 ] && ! command -v sudo >/dev/null; then
    fail "these packages are missing, and this is neither root nor is there sudo. As root, run:
  apt-get install --no-install-recommends ${missing[*]}"
  fi
  say "Installing ${missing[*]}"
  local log status=0
  log=$(mktemp)
  # A broken third-party source must not stand in the way: apt-get install says whether what it has is enough.
  run_as_root apt-get -q update >"$log" 2>&1 || say "apt-get update had errors; going on with the package lists that there are."
  run_as_root env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y install --no-install-recommends "${missing[@]}" >>"$log" 2>&1 </dev/null || status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    fail "apt-get could not install ${missing[*]}: see its last lines above."
  fi
  rm -f "$log"
}

# The memory that this shell may use, in MB: what is free, and no more than its container's limit.
available_memory() {
  local free limit
  free=$(awk '/^MemAvailable:/ { print int($2 / 1024) }' /proc/meminfo 2>/dev/null)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || cat /sys/fs/cgroup/memory/memory.limit_in_bytes 2>/dev/null)
  free=${free:-4096}
  case $limit in
  '' | *[!0-9]*) ;;
  *) [ ${#limit} -gt 15 ] || [ $((limit / 1048576)) -ge "$free" ] || free=$((limit / 1048576)) ;;
  esac
  say "$free"
}

# As many compilers as there are processors, each with the 2.5 GB that CGAL's templates take at the most.
number_of_jobs() {
  local jobs fitting
  jobs=$(nproc 2>/dev/null || say 1)
  fitting=$(($(available_memory) / 2500))
  [ "$fitting" -ge "$jobs" ] || jobs=$fitting
  [ "$jobs" -ge 1 ] || jobs=1
  say "$jobs"
}

# Whether the build directory is there and was made for this tree, not copied with another one.
is_configured() {
  grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root_dir" "$build_dir/CMakeCache.txt" 2>/dev/null &&
    { [ -f "$build_dir/build.ninja" ] || [ -f "$build_dir/Makefile" ]; }
}

# configure OPTION...
configure() {
  local generator=()
  if ! is_configured; then
    rm -rf "$build_dir/CMakeCache.txt" "$build_dir/CMakeFiles"
    ! command -v ninja >/dev/null || generator=(-G Ninja)
  fi
  cmake -S "$root_dir" -B "$build_dir" "${generator[@]}" "$@"
}

# build OPTION...: cmake --build with the jobs that fit.
build() {
  cmake --build "$build_dir" --parallel "$(number_of_jobs)" "$@"
}
