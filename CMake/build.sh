#!/usr/bin/env bash
# build.sh PRESET FOLDER [BUILD_PRESET]: configure and build a preset into FOLDER; show how far it is.
#
# All output goes to FOLDER/build.log. On a terminal one line counts percents; elsewhere there is a
# line for every tenth. After an error, the end of the log is printed.
set -euo pipefail

preset=$1 folder=$2 build_preset=${3:-$1}
cd "$(dirname "${BASH_SOURCE[0]}")/.."
mkdir -p "$folder"
log=$folder/build.log

show_progress() { # reads what Ninja prints, in lines that begin with [DONE/ALL]
  local line percent shown=0
  while IFS= read -r line; do
    [[ $line =~ ^\[([0-9]+)/([0-9]+)\] ]] && [ "${BASH_REMATCH[2]}" -gt 0 ] || continue
    percent=$((100 * BASH_REMATCH[1] / BASH_REMATCH[2]))
    if [ -t 1 ]; then
      printf '\rBuilding into %s: %d %%' "$folder" "$percent"
    elif [ "$percent" -ge $((shown + 10)) ]; then
      shown=$((percent / 10 * 10))
      echo "Building into $folder: $shown %"
    fi
  done
  [ ! -t 1 ] || echo
}

echo "Building into $folder"
if ! cmake --preset "$preset" >"$log" 2>&1 ||
  ! cmake --build --preset "$build_preset" 2>&1 | tee -a "$log" | show_progress; then
  tail -n 40 "$log"
  echo "The build failed; all of its output is in $log" >&2
  exit 1
fi
