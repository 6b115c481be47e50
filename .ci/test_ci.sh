# Sourced by test.sh ci: what takes other builds than the everyday one.

echo "== address and undefined-behaviour sanitizers"
cmake --preset sanitize >/dev/null
cmake --build build-sanitize
run_ctest build-sanitize -L unit -LE 'long|no-sanitizer'

echo "== Clang, warnings as errors"
cmake --preset release -B build-clang -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build-clang
run_ctest build-clang -L unit -LE 'long'

echo "== what needs the release build and more time"
cmake --preset release -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build
run_ctest build -L ci
