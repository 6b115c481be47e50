#!/usr/bin/env bash
# A stranger with a clean Debian 12 and the two packages: stranger.sh FOLDER_OF_DEBS SCRATCH [--paraview]
#
# A minimal Debian is set up in SCRATCH, the packages are installed there by apt with what they depend on, and the tutorials
# that they bring are followed to the letter, inside that Debian: this source tree is out of its reach. What comes out is
# read with VTK's Python, and under --paraview drawn by ParaView.
# Needs root (or sudo), the network and debootstrap.
set -euo pipefail
debs=$(realpath "$1")
mkdir -p "$2"
scratch=$(realpath "$2")
paraview=${3:-}
here=$(dirname "$(realpath "$0")")
if [ "$(id -u)" -ne 0 ]; then exec sudo "$(realpath "$0")" "$@"; fi

if [ ! -e "$scratch/base/.whole" ]; then
  rm -rf "${scratch:?}/base"
  debootstrap --variant=minbase bookworm "$scratch/base" >"$scratch/debootstrap.log"
  touch "$scratch/base/.whole"
fi
root=$scratch/stranger
rm -rf "$root"
cp -a "$scratch/base" "$root"
cp "$debs"/similitude_*.deb "$debs"/similitude-dev_*.deb "$root/srv"
cp "$here/follow.py" "$root/srv"

# Folder, name and environment of somebody who has never seen this project; processes and mounts end with the command.
inside() {
  unshare --mount --pid --fork chroot "$root" env -i HOME=/home/stranger PATH=/usr/bin:/bin:/usr/sbin:/sbin LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive OMP_NUM_THREADS=1 bash -euc "mount -t proc proc /proc; $*"
}

echo "-- apt installs the packages with what they depend on"
extra="libgtest-dev python3 python3-vtk9 python3-numpy"
if [ -n "$paraview" ]; then extra="libgtest-dev python3 paraview python3-paraview xvfb xauth"; fi
inside "apt-get update -qq; apt-get install -y -qq --no-install-recommends /srv/similitude_*.deb /srv/similitude-dev_*.deb $extra" \
  >"$scratch/apt.log" 2>&1 || { tail -30 "$scratch/apt.log" >&2; exit 1; }
inside "similitude --version; similitude plugins failures" | tee "$scratch/version.txt"
grep -qx "No file was refused." "$scratch/version.txt"

echo "-- the tutorials that the package brings"
pages=/usr/share/doc/similitude-dev/plugin-authors
follow="cd /home/stranger; python3 /srv/follow.py $paraview $pages/{drag,contact,scaling,effect,fluid}.md"
if [ -n "$paraview" ]; then follow="cd /home/stranger; xvfb-run -a python3 /srv/follow.py $paraview $pages/{drag,contact,scaling,effect,fluid}.md"; fi
inside "mkdir -p /home/stranger; $follow"

echo "-- the results"
if [ -n "$paraview" ]; then
  for picture in gibilaro/gibilaro sliding/sliding grains/grains rough/rough wind/wind; do
    [ "$(stat -c %s "$root/home/stranger/$picture.png")" -gt 10000 ] || { echo "$picture.png is all but empty" >&2; exit 1; }
  done
else
  measure=/usr/share/similitude/examples/05_paraview_view/measure.py
  inside "cd /home/stranger; for run in gibilaro/results/gibilaro sliding/results/sliding; do python3 $measure \$run | tail -1; done"
fi
