#!/usr/bin/env bash
# Installs what is missing, builds, and simulates the spouted bed with draft plates: ./run.sh
# Another case, or any other command of the program: ./run.sh run configs/… | check … | plugins list | …
set -euo pipefail

# Debian packages that it takes to build and run.
build_packages=(
  g++ cmake ninja-build pkgconf
  libeigen3-dev                          # linear algebra of the gas solver
  libboost-dev libboost-filesystem-dev   # Boost.DLL loads plugins
  libyaml-cpp-dev                        # case files
  libvtk9-dev                            # ParaView files
  libcli11-dev                           # command line
  libfmt-dev                             # messages
  nlohmann-json3-dev                     # manifests, --json
  libelf-dev                             # reads a plugin's tag before it is loaded
  libhdf5-dev                            # checkpoints
  libjs-chart.js                         # charts of reports, built into the program
)

# install_missing PACKAGE…: quiet when nothing is missing; uses sudo when not root.
install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f '${db:Status-Abbrev}' "$package" 2>/dev/null | grep -q '^ii' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return 0
  echo "installing Debian packages: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "error: packages are missing and there is no sudo. As root: apt-get install ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends "${missing[@]}" >/dev/null
}

# test.sh sources this file for the two definitions above.
[ "${BASH_SOURCE[0]}" = "$0" ] || return 0

cd "$(dirname "$0")"
install_missing "${build_packages[@]}"
cmake --preset release >/dev/null -DSIMILITUDE_TESTS=OFF -B build-run
cmake --build build-run

if [ $# -eq 0 ]; then
  set -- run configs/quickstart.yaml --force
fi
exec build-run/bin/similitude "$@"
