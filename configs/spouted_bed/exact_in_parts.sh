#!/usr/bin/env bash
# The paper's bed, all 461 000 grains, 2 s of spouting, with a spring of 200 N/m that allows longer steps: days on one core, in parts.
#   configs/spouted_bed/exact_in_parts.sh [DIR]
# Then compare it with the four scaling laws: configs/studies/scaling.yaml, reference: {run: DIR}.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
exec "$here/../yue2020/exact_in_parts.sh" "$here/exact.yaml" "${1:-results/spouted_bed_exact}" --set "models.contact.stiffness=200 N/m"
