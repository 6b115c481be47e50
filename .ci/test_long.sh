# Sourced by test.sh long: hours.
cmake --preset release -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build
run_ctest build -L long --parallel 1
