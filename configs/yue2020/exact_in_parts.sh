#!/usr/bin/env bash
# The exact bed of this folder, or any other case, in parts of 0.1 s of the real bed: breaking it off loses at most the time since the
# last checkpoint, and calling it again goes on.
#   configs/yue2020/exact_in_parts.sh [CASE.yaml [DIR [option of `similitude run` …]]]
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
case_file=${1:-$here/exact.yaml}
folder=${2:-results/yue2020/exact}
options=("${@:3}")
similitude=${SIMILITUDE:-build/bin/similitude}

end=$("$similitude" check "$case_file" "${options[@]}" >/dev/null && sed -n 's/^time: *{end: *\([0-9.]*\) s.*/\1/p' "$case_file")
for part in $(seq -f '%.1f' 0.1 0.1 "$end"); do
  resume=()
  if [ -d "$folder/checkpoints" ]; then resume=(--resume); fi
  if /usr/bin/python3 - "$folder" "$part" <<'PYTHON'; then continue; fi
import json, pathlib, sys
manifest = pathlib.Path(sys.argv[1]) / "manifest.json"
sys.exit(0 if manifest.exists() and (json.loads(manifest.read_text()).get("simulated_s") or 0) >= float(sys.argv[2]) - 1e-6 else 1)
PYTHON
  "$similitude" run "$case_file" -o "$folder" "${options[@]}" --until "$part s" "${resume[@]}"
done
