# Sourced by test.sh ci: what takes other builds than the everyday one, and the beds that take minutes.

echo "== address and undefined-behaviour sanitizers"
# Leaks are not looked for: plugins and VTK's tables live until the process ends, on purpose.
export ASAN_OPTIONS=detect_leaks=0
cmake --preset sanitize >/dev/null
cmake --build build-sanitize
run_ctest build-sanitize -L unit -LE 'ci|long'
# Spoilt files ask for more memory than there is: that is an error to be told, here too.
ASAN_OPTIONS=$ASAN_OPTIONS:allocator_may_return_null=1 run_ctest build-sanitize -R '^fuzz\.inputs_2000$'

echo "== Clang, warnings as errors: the framework, every plugin, and a run"
cmake --preset release -B build-clang -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
  -DSIMILITUDE_TESTS=OFF -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build-clang
build-clang/bin/similitude run tests/paraview/case.yaml -o build-clang/small_bed --force

echo "== what needs the release build and more time"
cmake --preset release -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build
run_ctest build -L ci | tee build/ci_tests.log

echo "== portable packages: what nobody asks for costs nothing, counted"
cmake --preset portable -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build-portable
SIMILITUDE=build-portable/bin/similitude /usr/bin/python3 tests/effects/footprint_test.py

echo "== a stranger with a clean Debian and the packages follows the tutorials for plugin authors; ParaView draws the results"
(cd build-portable && rm -f ./*.deb && cpack)
tests/plugin_authors/stranger.sh build-portable build-portable/stranger --paraview

# A gate that skips itself, e.g. counts of instructions under another compiler, must not be taken for one that holds.
if grep '(Skipped)$' build/ci_tests.log; then
  echo "== THE TESTS ABOVE DID NOT RUN: build/ci_tests.log says why"
fi
