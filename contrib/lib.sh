# SPDX-License-Identifier: LGPL-2.1-or-later
# shellcheck shell=bash disable=SC2034
# Shared by the scripts in contrib/; to be sourced by bash, not to be run.

set -euo pipefail

ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
BUILD=${BUILD:-$ROOT/build}

# What building, running and testing need, as Debian packages.
PACKAGES=(
  libdeal.ii-dev libboost-program-options-dev libgtest-dev
  nlohmann-json3-dev
  cmake ninja-build g++ openmpi-bin python3
)
PLOT_PACKAGES=(python3 python3-numpy python3-matplotlib python3-vtk9)

say() {
  printf 'thalweg: %s\n' "$*" >&2
}

fail() {
  say "$*"
  exit 1
}

# Prints those of the given Debian packages that are not installed.
missing_packages() {
  local package state
  for package in "$@"; do
    state=$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) || true
    [ "$state" = installed ] || printf '%s\n' "$package"
  done
}

# Installs those of the given Debian packages that are missing. Whoever has
# deal.II elsewhere says so with DEAL_II_DIR and looks after the rest too.
install_packages() {
  local missing sudo=()
  [ -z "${DEAL_II_DIR:-}" ] || return 0
  if ! command -v dpkg-query >/dev/null; then
    fail "this is not a Debian system. Install deal.II 9.4.1 or newer with" \
      "MPI, p4est, Trilinos and muParser, CMake, Ninja and Boost, and set" \
      "DEAL_II_DIR to the place of deal.II."
  fi
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -gt 0 ] || return 0

  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || fail "these packages are missing, and" \
      "without being root or having sudo they cannot be installed here:" \
      "${missing[*]}"
    sudo=(sudo)
  fi
  say "installing Debian packages: ${missing[*]}"
  "${sudo[@]}" apt-get update >&2 ||
    fail "'apt-get update' failed: is there a network?"
  "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install --yes \
    --no-install-recommends "${missing[@]}" >&2 ||
    fail "installing the packages failed; the lines above say why."
}

# Configures a build: its type where there is none yet, and options of CMake.
# All else in a build that exists stays as the user configured it.
configure() {
  local log type=${1:-Release} options=("${@:2}")
  if [ ! -f "$BUILD/build.ninja" ] && [ ! -f "$BUILD/Makefile" ]; then
    options+=(-G Ninja -DCMAKE_BUILD_TYPE="$type")
  elif has_options "${options[@]}"; then
    return 0
  fi
  log=$(mktemp)
  say "configuring a $type build in $BUILD"
  if ! cmake -S "$ROOT" -B "$BUILD" "${options[@]}" >"$log" 2>&1; then
    cat "$log" >&2
    rm -f "$log"
    fail "configuring failed; the lines above say why."
  fi
  rm -f "$log"
}

# Whether $BUILD was configured with these options (-DNAME=VALUE).
has_options() {
  local option
  for option; do
    option=${option#-D}
    grep -q "^${option%%=*}:[A-Z]*=${option#*=}\$" "$BUILD/CMakeCache.txt" ||
      return 1
  done
}

# Builds the given targets, all without any. Where there is nothing to do it
# says nothing.
build() {
  local jobs=${JOBS:-$(build_jobs)} targets=()
  configure
  [ $# -eq 0 ] || targets=(--target "$@")
  [ -e "$BUILD/.ninja_log" ] ||
    say "building with $jobs jobs (JOBS=N sets their number); this takes some" \
      "minutes."
  cmake --build "$BUILD" --parallel "$jobs" ${targets[@]+"${targets[@]}"} 2>&1 |
    { grep --line-buffered -vE \
      'Re-checking globbed|no work to do|Entering directory' || true; } >&2 ||
    fail "building failed; the lines above say why."
}

# The cores this process may use. nproc alone takes the threads that a user
# allows OpenMP for cores.
n_cores() { env -u OMP_NUM_THREADS -u OMP_THREAD_LIMIT nproc; }

# As many compilers at once as there are cores, and at most one for each
# 1.5 GB of memory.
build_jobs() {
  local cores memory
  cores=$(n_cores)
  memory=$(awk '/MemAvailable/ {print int($2 / 1500000)}' /proc/meminfo)
  [ "$memory" -ge 1 ] || memory=1
  echo $((cores < memory ? cores : memory))
}
