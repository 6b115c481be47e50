#!/usr/bin/env bash
# Simulates a small bed and looks at its results with ParaView's own readers and with the run's view.py.
set -euo pipefail
rm -rf "$SCRATCH/run" && mkdir -p "$SCRATCH/modules"
cd "$SCRATCH"

modules=$SCRATCH/modules/usr/lib/python3/dist-packages
if [ ! -d "$modules" ]; then
  (cd modules && apt-get download -qq python3-paraview && dpkg -x python3-paraview_*.deb .)
fi

"$SIMILITUDE" run "$SOURCE/tests/paraview/case.yaml" -o "$SCRATCH/run"

export PYTHONPATH=$modules
# One X server for both: a second start may meet the first one's closing socket.
xvfb-run -a bash -euc '
  /usr/bin/python3 "$SOURCE/tests/paraview/read_in_paraview.py" "$SCRATCH/run" 0.02
  /usr/bin/python3 "$SCRATCH/run/view.py" --screenshot "$SCRATCH/bed.png"'
size=$(stat -c %s "$SCRATCH/bed.png")
[ "$size" -gt 10000 ] || { echo "the picture is all but empty: $size bytes" >&2; exit 1; }
