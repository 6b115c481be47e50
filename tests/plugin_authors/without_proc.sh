#!/usr/bin/env bash
# Where nothing may be mounted a chroot has no /proc: without_proc.sh ROOT gives it what programs here ask of it, which is where
# the program of a process lies. Where /proc is there it does nothing.
set -euo pipefail
if [ ! -e "$1/proc/self" ]; then
  echo "-- nothing may be mounted here: a stand-in for /proc"
  mkdir -p "$1/proc/self"
  ln -s /usr/bin/similitude "$1/proc/self/exe"
fi
