#!/usr/bin/env bash
# What a stranger types in a clean Debian, with the packages in /srv: type.sh [--paraview]. Run by stranger.sh, in its chroot.
set -euo pipefail
paraview=${1:-}

echo "-- apt installs the packages with what they depend on"
with=(libgtest-dev python3)
if [ -n "$paraview" ]; then with+=(paraview python3-paraview xvfb xauth); else with+=(python3-vtk9 python3-numpy); fi
{
  apt-get update -qq
  apt-get install -y -qq --no-install-recommends /srv/similitude_*.deb /srv/similitude-dev_*.deb "${with[@]}"
} >/srv/apt.log 2>&1 || { tail -30 /srv/apt.log; exit 1; }
mkdir -p ~/seen
cd ~
similitude --version
similitude plugins failures | tee failures.txt
grep -qx "No file was refused." failures.txt

echo "-- the tutorials that the package brings"
under_x=()
python=python3
if [ -n "$paraview" ]; then under_x=(xvfb-run -a) python=pvpython; fi
"${under_x[@]}" python3 /srv/follow.py $paraview /usr/share/doc/similitude/plugin-authors/{drag,contact,scaling,effect,fluid}.md

echo "-- each new model with every one that ships"
SIMILITUDE_PLUGIN_PATH=$(printf '%s:' ~/*/build) python3 /srv/mix.py gibilaro/case.yaml

echo "-- the results"
for run in gibilaro sliding; do
  $python /usr/share/similitude/examples/05_paraview_view/measure.py $run/results/$run seen/$run.csv
  echo "$run, $(head -1 seen/$run.csv): $(tail -1 seen/$run.csv)"
done
if [ -n "$paraview" ]; then
  $python /srv/pictures.py {gibilaro/gibilaro,sliding/sliding,grains/grains,rough/rough,wind/wind}.png
  cp */*.png seen
fi
