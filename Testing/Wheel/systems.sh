#!/usr/bin/env bash
# systems.sh [OPTION...] SUITE...: whether a wheel works on fresh systems with pip alone; run it as root.
#
# For each suite of Debian (bookworm, trixie ...) makes a minimal system by debootstrap, with python3-venv
# and nothing of VTK. There, a user without rights makes a virtual environment, installs the wheel for that
# Python, and goes from a scan to a painted surface, a page and a picture. Prints seconds and megabytes of
# each step. A picture needs the system's OpenGL, which is installed for the last step only.
#
#   --wheels DIR   with a wheel for the Python of each suite; default build/wheel/dist
#   --folder DIR   for the systems, 2 GB each, kept as they are made, and their logs; default build/wheel/systems
#   --mirror URL   of Debian; default: that of this machine
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Systems/debian.sh"

folder=$source_dir/build/wheel/systems wheels=$source_dir/build/wheel/dist mirror=''
while [[ ${1:-} == --* ]]; do
  case $1 in
    --wheels) wheels=$(realpath "$2"); shift 2 ;;
    --folder) folder=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --mirror) mirror=$2; shift 2 ;;
    *) echo "No option $1" >&2; exit 2 ;;
  esac
done
[ "$#" -gt 0 ] || usage "${BASH_SOURCE[0]}"
require_debootstrap

# steps: what the user does in the home folder
steps='
set -e
timed()
{
  local start=$(date +%s%N) hundredths
  "$@" >"$HOME/log" 2>&1 || { cat "$HOME/log"; echo "Failed: $*"; exit 1; }
  hundredths=$((($(date +%s%N) - start) / 10000000))
  printf "%s\n    %d.%02d s\n" "$*" $((hundredths / 100)) $((hundredths % 100))
}
echo "Debian $(cat /etc/debian_version), $(python3 --version)"
wheel=$(ls wheels/*"$(python3 -c "import sys; print(\"cp%d%d\" % sys.version_info[:2])")"*.whl)
timed python3 -m venv venv
timed venv/bin/python -m pip install "$wheel"
du -sm venv | sed "s/\t.*/ MB: the virtual environment/"
du -sm venv/lib/python3*/site-packages/conformalsom | sed "s/\t.*/ MB of it: conformalsom/"
timed venv/bin/python -c "import vtkmodules.vtkCommonCore, numpy"
timed venv/bin/python -c "import conformalsom"
timed venv/bin/python -c "import conformalsom"
timed venv/bin/python make_scan.py
timed venv/bin/conformalsom scan.ply -o surface.glb -o surface.html --report figures.json
timed venv/bin/python -c "import conformalsom as cs; cs.learn(\"scan.ply\").smooth(64_000).save(\"again.glb\")"
ls -l --block-size=K surface.glb surface.html again.glb | awk "{print \$9, \$5}"
'
picture='
set -e
venv/bin/conformalsom scan.ply -o third.glb --picture picture.png
ls -l --block-size=K picture.png | awk "{print \$9, \$5}"
'

mkdir -p "$folder"
failed=()
for suite in "$@"; do
  root=$folder/$suite base=$folder/$suite.base
  if [ ! -e "$base/complete" ]; then
    make_system "$suite" "$base" python3-venv >"$base.log" 2>&1
  fi
  rm -rf --one-file-system "$root"
  cp --archive --reflink=auto "$base" "$root"
  if [ -n "${PIP_CERT:-}" ]; then # a machine whose network has certificates of its own
    cp --dereference "$PIP_CERT" "$root/etc/ssl/certs/ca-certificates.crt"
  fi
  mkdir "$root/home/tester/wheels"
  cp "$wheels"/conformalsom-*.whl "$root/home/tester/wheels"
  cp "$source_dir/Testing/Wheel/make_scan.py" "$root/home/tester"
  chroot "$root" chown -R tester /home/tester
  echo "== $suite"
  if ! within "$root" tester "$steps"; then
    failed+=("$suite")
    continue
  fi
  if ! {
    within "$root" root 'apt-get -qq update && apt-get -qq install --yes --no-install-recommends libegl1 libgl1-mesa-dri libgl1 libxrender1 xvfb xauth >/dev/null 2>&1'
    within "$root" tester "export PATH=\$PATH; xvfb-run -a bash -c '$picture'"
  }; then
    failed+=("$suite: picture")
  fi
done
[ "${#failed[@]}" -eq 0 ] || { echo "Failed: ${failed[*]}" >&2; exit 1; }
