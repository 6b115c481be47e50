#!/usr/bin/env bash
# Builds and passes the tests.
#   ./test.sh        everyday tests, under 15 minutes on two cores from a clean clone
#   ./test.sh ci     what CI adds: sanitizers, the other compiler, the installed SDK
#   ./test.sh long   hours: real ParaView, slow beds
set -euo pipefail
cd "$(dirname "$0")"
. ./run.sh   # build_packages, install_missing

# Debian packages that the tests need on top.
test_packages=(
  libgtest-dev libgmock-dev
  libbenchmark-dev                                        # prices of models
  python3 python3-vtk9 python3-numpy python3-matplotlib   # read results back, draw the bed
  python3-jsonschema python3-yaml                         # validate the schema of case files
)
ci_packages=(
  gfortran                 # a drag law in Fortran
  clang libomp-dev valgrind                        # valgrind counts instructions
  chromium chromium-driver python3-selenium        # reports as people see them
  dpkg-dev mmdebstrap                              # packages, and a clean Debian that installs them
)
long_packages=(paraview xvfb)

# run_ctest FOLDER ARGS…: the tests of a build folder, two at a time.
run_ctest() {
  local folder=$1
  shift
  ctest --test-dir "$folder" --output-on-failure --parallel 2 --no-tests=error "$@"
}

install_missing "${build_packages[@]}" "${test_packages[@]}"
case ${1:-everyday} in
  everyday)
    cmake --preset release -DSIMILITUDE_WERROR=ON >/dev/null
    cmake --build build
    run_ctest build -LE 'ci|long'
    ;;
  ci)
    install_missing "${ci_packages[@]}"
    . .ci/test_ci.sh
    ;;
  long)
    install_missing "${long_packages[@]}"
    . .ci/test_long.sh
    ;;
  *)
    echo "usage: ./test.sh [ci|long]" >&2
    exit 2
    ;;
esac
