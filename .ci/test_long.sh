# Sourced by test.sh long: hours.
cmake --preset release -DSIMILITUDE_WERROR=ON >/dev/null
cmake --build build
run_ctest build -L long -E '^fuzz\.' --parallel 1

echo "== 100 000 spoilt inputs under address and undefined-behaviour sanitizers; broken off, it goes on where it was"
cmake --preset sanitize >/dev/null
cmake --build build-sanitize
ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1 run_ctest build-sanitize -R '^fuzz\.inputs_100000$'

# The exact bed that configs/studies/scaling.yaml compares with: hours, once.
if [ ! -e results/small_bed_exact ]; then
  build/bin/similitude run configs/small_bed/exact.yaml -o results/small_bed_exact
fi

echo "== measured beds and the paper's at full size, days: break it off as you like, it goes on where it was"
docs/validation/run_all.py
