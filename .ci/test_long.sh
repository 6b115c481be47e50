# Sourced by test.sh long: hours.
cmake --preset release -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build
run_ctest build -L long --parallel 1

# The exact bed that configs/studies/scaling.yaml compares with: hours, once.
if [ ! -e results/small_bed_exact ]; then
  build/bin/similitude run configs/small_bed/exact.yaml -o results/small_bed_exact
fi
