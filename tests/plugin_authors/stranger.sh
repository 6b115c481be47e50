#!/usr/bin/env bash
# A stranger with a clean Debian 12 and the two packages: stranger.sh FOLDER_OF_DEBS SCRATCH [--paraview]
#
# A minimal Debian is set up in SCRATCH/debian and type.sh is run inside it, where this source tree is out of reach: apt
# installs the packages with what they depend on, the tutorials that they bring are followed to the letter, and what comes
# out is read with VTK's Python, or under --paraview drawn by ParaView. Pictures and numbers are left in SCRATCH/seen.
# Needs mmdebstrap, the network, and root (or sudo). Mounts are made where they are allowed and done without where not.
set -euo pipefail
if [ $# -lt 2 ]; then
  echo "usage: stranger.sh FOLDER_OF_DEBS SCRATCH [--paraview]" >&2
  exit 2
fi
program=$(realpath "$0")
if [ "$(id -u)" -ne 0 ]; then
  command -v sudo >/dev/null || { echo "stranger.sh: a Debian is set up as root, and there is no sudo." >&2; exit 1; }
  exec sudo --preserve-env=http_proxy,https_proxy,no_proxy "$program" "$@"
fi
command -v mmdebstrap >/dev/null || { echo "stranger.sh: mmdebstrap is missing: apt-get install mmdebstrap" >&2; exit 1; }
here=$(dirname "$program")
debs=$(realpath "$1")
for package in similitude similitude-dev; do
  ls "$debs/$package"_*.deb >/dev/null || { echo "stranger.sh: no package $package in $debs: make it with cpack" >&2; exit 1; }
done
rm -rf "${2:?}/debian" "$2/seen"
mkdir -p "$2/seen"
scratch=$(realpath "$2")

# Environment of somebody who has never seen this project; only the way to the network is the host's.
clean="env -i HOME=/home/stranger PATH=/usr/bin:/bin:/usr/sbin:/sbin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive OMP_NUM_THREADS=1"
for proxy in http_proxy https_proxy no_proxy; do
  if [ -n "${!proxy:-}" ]; then clean+=" $proxy=${!proxy}"; fi
done

# Where namespaces are allowed, mounts and processes end with the command, whatever happens.
apart=()
if unshare --mount --pid --fork true 2>/dev/null; then apart=(unshare --mount --pid --fork --kill-child); fi

echo "-- a clean Debian 12"
"${apart[@]}" mmdebstrap --quiet --variant=minbase --aptopt='Acquire::Retries "3"' \
  --customize-hook="cp '$debs'/similitude_*.deb '$debs'/similitude-dev_*.deb '$here'/type.sh '$here'/*.py \"\$1/srv\"" \
  --customize-hook="'$here/without_proc.sh' \"\$1\"" \
  --customize-hook="chroot \"\$1\" $clean bash /srv/type.sh ${3:-}" \
  --customize-hook="cp -r \"\$1/home/stranger/seen/.\" '$scratch/seen'" \
  bookworm "$scratch/debian" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}"
