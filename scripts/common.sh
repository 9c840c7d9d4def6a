# Shared by the scripts of this folder, which source it. Needs bash.

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build

say() { printf '== %s\n' "$*"; }
fail() { printf 'error: %s\n' "$*" >&2; exit 1; }

# compile jobs: one per processor, but four gigabytes of memory for each
jobs=$(nproc)
memory_jobs=$(awk '/^MemAvailable:/ { print int($2 / 4194304) }' /proc/meminfo 2>/dev/null || echo "$jobs")
[ "${memory_jobs:-0}" -ge "$jobs" ] || jobs=$(( memory_jobs > 1 ? memory_jobs : 1 ))

# Debian's own interpreter, which has Debian's modules, even where another one comes first in the path
python=/usr/bin/python3

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null 2>&1; then
    sudo "$@"
  else
    fail "must be run as root, or with sudo installed, to install: ${missing[*]}"
  fi
}

is_installed() { [ "$(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# install_packages NAME...: those that are missing
install_packages() {
  command -v apt-get >/dev/null 2>&1 || fail "this script installs Debian packages, but there is no apt-get; needed: $*"
  missing=()
  local package
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  [ "${#missing[@]}" -gt 0 ] || return 0
  say "installing ${missing[*]}"
  as_root apt-get update -q || fail "apt-get update did not work; the packages ${missing[*]} are missing"
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install -y -q --no-install-recommends "${missing[@]}" \
    || fail "apt-get could not install ${missing[*]}"
}

build_packages=(g++ make cmake libcgal-dev libeigen3-dev libboost-dev libboost-program-options-dev libtbb-dev
                nlohmann-json3-dev)

# extract_models: CGAL's data folder, from Debian's libcgal-demo, in build/cgal-data; sets CGAL_DATA_DIR
extract_models() {
  export CGAL_DATA_DIR=$build/cgal-data/data
  [ ! -e "$build/cgal-data/complete" ] || return 0
  local archive=/usr/share/doc/libcgal-dev/data.tar.gz
  rm -rf "$build/cgal-data"
  mkdir -p "$build/cgal-data/package"
  if [ ! -e "$archive" ]; then
    # installations without documentation do not have it, so it is taken from the package itself
    say "downloading CGAL's models"
    (cd "$build/cgal-data/package" && apt-get -q download libcgal-demo && dpkg-deb -x libcgal-demo_*.deb .) \
      || { missing=(); as_root apt-get update -q \
           && (cd "$build/cgal-data/package" && apt-get -q download libcgal-demo && dpkg-deb -x libcgal-demo_*.deb .); } \
      || fail "CGAL's models (Debian package libcgal-demo) could not be downloaded"
    archive=$build/cgal-data/package$archive
  fi
  tar -xzf "$archive" -C "$build/cgal-data" || fail "$archive could not be unpacked"
  [ -d "$CGAL_DATA_DIR/meshes" ] || fail "$archive has no folder data/meshes"
  rm -rf "$build/cgal-data/package"
  touch "$build/cgal-data/complete"
}

# configure FOLDER OPTION...: a build of the checkout in build/FOLDER
configure() {
  local folder=$build/$1 launcher=()
  shift
  # a build folder knows its path; one that came with a copied checkout is made anew
  if [ -e "$folder/CMakeCache.txt" ] && ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt"; then
    rm -rf "$folder"
  fi
  ! command -v ccache >/dev/null 2>&1 || launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  mkdir -p "$folder"
  cmake -S "$root" -B "$folder" "${launcher[@]}" "$@" >"$folder/configure.log" 2>&1 \
    || { cat "$folder/configure.log" >&2; fail "configuring $folder failed"; }
}
