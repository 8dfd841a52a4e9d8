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
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

folder=$source_dir/build/wheel/systems wheels=$source_dir/build/wheel/dist mirror=''
while [[ ${1:-} == --* ]]; do
  case $1 in
    --wheels) wheels=$(realpath "$2"); shift 2 ;;
    --folder) folder=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --mirror) mirror=$2; shift 2 ;;
    *) echo "No option $1" >&2; exit 2 ;;
  esac
done
if [ "$#" -eq 0 ]; then
  sed -n '2,/^set/s/^# \?//p' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
[ "$(id -u)" -eq 0 ] || { echo "Only root can make systems" >&2; exit 2; }
bash "$source_dir/CMake/install-packages.sh" debootstrap
if [ -z "$mirror" ]; then
  mirror=$(apt-get indextargets --format '$(LABEL) $(REPO_URI)' | sed -n 's/^Debian //p' | head -n 1)
fi
: "${mirror:?This machine knows no mirror of Debian; name one by --mirror}"

# within ROOT USER COMMAND: all mounts end with the command
within()
{
  root=$1 user=$2 command=$3 unshare --mount bash -c '
    set -e
    for system in proc sys dev; do mount --rbind "/$system" "$root/$system"; done
    exec chroot "$root" su - "$user" --command "export DEBIAN_FRONTEND=noninteractive; $command"'
}

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
  if [ ! -e "$base.complete" ]; then
    rm -rf --one-file-system "$base"
    debootstrap --variant=minbase --include=ca-certificates,python3-venv "$suite" "$base" "$mirror" sid >"$base.log" 2>&1
    touch "$base.complete"
  fi
  rm -rf --one-file-system "$root"
  cp --archive --reflink=auto "$base" "$root"
  cp /etc/resolv.conf /etc/hosts "$root/etc"
  apt-config dump Acquire >"$root/etc/apt/apt.conf.d/01host"
  if [ -n "${PIP_CERT:-}" ]; then # a machine whose network has certificates of its own
    cp --dereference "$PIP_CERT" "$root/etc/ssl/certs/ca-certificates.crt"
  fi
  chroot "$root" useradd --create-home --shell /bin/bash tester
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
