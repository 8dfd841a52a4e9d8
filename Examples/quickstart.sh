#!/usr/bin/env bash
# quickstart.sh [SCAN [TEXTURE]] [OPTION...]: from a scan to a painted surface on a fresh Debian.
#
# Installs what is missing, builds the filters it uses into build/release (all of them, where they are
# built already) and runs the command conformalsom, whose options may follow (--help lists them).
# Without SCAN, a scan and a picture made by code are used; without options too, readers and writers
# that this does not take are not built.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

bash "$root/CMake/install-packages.sh" cmake ninja-build g++ libvtk9-dev python3-vtk9 \
  python3-numpy libeigen3-dev libexpat1-dev zlib1g-dev libmeshoptimizer-dev libjs-three xvfb xauth libgl1-mesa-dri

cache=$root/build/release/CMakeCache.txt
preset=quickstart
[ $# -eq 0 ] || preset=quickstart-files
if [ -e "$cache" ]; then # what was built stays
  case $(sed -n 's/^CONFORMALSOM_CLASSES:[A-Z]*=//p' "$cache") in
    '') preset=release ;;
    *'vtk*Reader'*) preset=quickstart-files ;;
  esac
fi
bash "$root/CMake/build.sh" "$preset" build/release release

display=()
[ -n "${DISPLAY:-}" ] || display=(xvfb-run --auto-servernum)
output=$root/build/quickstart
if [ $# -eq 0 ] || [[ $1 == -* ]]; then
  /usr/bin/python3 "$root/Examples/Python/toy_bear.py" "$output" --overwrite # of an earlier run
  inputs=("$output/bear.vtp" --texture "$output/rosette.png")
else
  inputs=("$1")
  shift
  if [ $# -gt 0 ] && [[ $1 != -* ]]; then
    inputs+=(--texture "$1")
    shift
  fi
fi
echo "Writing quickstart.png and surface.vtp, .glb, .obj and .html into $output"
exec "${display[@]}" "$root/build/release/bin/conformalsom" "${inputs[@]}" --measure --overwrite \
  --output "$output/surface.vtp" --output "$output/surface.glb" --output "$output/surface.obj" \
  --output "$output/surface.html" \
  --picture "$output/quickstart.png" "$@"
