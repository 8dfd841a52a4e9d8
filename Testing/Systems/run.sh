#!/usr/bin/env bash
# run.sh [OPTION...] SUITE...: whether the README's commands work on fresh systems; run it as root.
#
# For each suite of Debian (bookworm, trixie, forky ...) makes a minimal system by debootstrap, clones
# the last commit into it, and there, as a user who is not root but may sudo, runs
# Examples/quickstart.sh, without and with files, and Testing/run.sh. Prints a row for each: whether the
# first command built and ran, whether its figures equal Testing/Systems/figures.txt, whether the second
# ran, and how many tests passed, of VTK and of ParaView. Fails if a row is not all well.
#
#   --quickstart   without Testing/run.sh
#   --folder DIR   for the systems, 8 GB each, and for their logs; default build/systems
#   --cache DIR    keep packages and what ccache compiled there for the next run
#   --keep         go on in systems that are there, with the packages they have
#   --mirror URL   of Debian; default: that of this machine
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/debian.sh"

folder=$source_dir/build/systems cache='' keep='' mirror='' tested=yes
while [[ ${1:-} == --* ]]; do
  case $1 in
    --folder) folder=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --quickstart) tested=''; shift ;;
    --cache) cache=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --keep) keep=yes; shift ;;
    --mirror) mirror=$2; shift 2 ;;
    *) echo "No option $1" >&2; exit 2 ;;
  esac
done
[ "$#" -gt 0 ] || usage "${BASH_SOURCE[0]}"
require_debootstrap

home=home/tester
clone=$home/ConformalSOM

# in_system ROOT USER COMMAND: with the cache, if there is one
in_system()
{
  if [ -z "$cache" ]; then
    within "$@"
    return
  fi
  local kept
  kept=$cache/$(basename "$1")
  within "$1" "$2" "export CCACHE_DIR=/var/cache/ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
    export CCACHE_SLOPPINESS=pch_defines,time_macros; $3" \
    "$kept/archives" /var/cache/apt/archives "$kept/ccache" /var/cache/ccache
}

# prepare SUITE ROOT
prepare()
{
  if [ -z "$keep" ] || [ ! -e "$2/complete" ]; then
    make_system "$1" "$2" sudo
  fi
  echo 'tester ALL=(ALL) NOPASSWD: ALL' >"$2/etc/sudoers.d/tester"
  if [ -n "$cache" ]; then
    mkdir -p "$cache/$1/archives/partial" "$cache/$1/ccache" "$2/var/cache/ccache"
    chmod a+rwx "$cache/$1/ccache"
    in_system "$2" root 'apt-get update && apt-get install --yes --no-install-recommends ccache'
  fi
  rm -rf "${2:?}/$clone"
  git clone --no-hardlinks "$source_dir" "$2/$clone"
  chroot "$2" chown --recursive tester: "/$clone"
}

# version ROOT PACKAGE: without Debian's own part
version()
{
  chroot "$1" dpkg-query --show --showformat '${Version}' "$2" 2>/dev/null | sed 's/^[0-9]*://; s/[+-].*//'
}

# tests LOG: how many passed, of how many
tests()
{
  local failed='' total='' skipped
  [ ! -e "$1" ] || read -r failed total <<<"$(sed -nE \
    's/.*tests passed, ([0-9]+) tests? failed out of ([0-9]+)$/\1 \2/p' "$1")"
  [ -n "$total" ] || { echo none; return; }
  skipped=$(grep -c ' (Skipped)$' "$1" || true)
  echo "$((total - failed - skipped)) of $total, $skipped skipped"
}

# What failed last is shown; not by ||, after which bash goes on within a function.
said=''
trap '[ $? -eq 0 ] || [ -z "$said" ] || tail "$said" >&2' EXIT

row='%-10s %-8s %-8s %-8s %-10s %-8s %-10s %-26s %s\n'
printf "$row" suite VTK ParaView Python quickstart figures "own files" tests "tests of the plugin"
status=0
for suite in "$@"; do
  root=$folder/$suite
  mkdir -p "$folder"
  said=$root.log
  prepare "$suite" "$root" >"$said" 2>&1
  said=''
  quickstart=ran figures=equal
  in_system "$root" tester 'cd ConformalSOM && bash Examples/quickstart.sh' \
    >"$root.quickstart.log" 2>&1 </dev/null || { quickstart=failed; status=1; }
  grep --extended-regexp '^(learned|smooth) ' "$root.quickstart.log" |
    cmp --quiet - "$source_dir/Testing/Systems/figures.txt" || { figures=differ; status=1; }
  own=ran
  in_system "$root" tester 'cp ConformalSOM/build/quickstart/{surface.obj,rosette.png} . &&
    cd ConformalSOM && bash Examples/quickstart.sh ~/surface.obj ~/rosette.png' \
    >"$root.files.log" 2>&1 </dev/null || { own=failed; status=1; }
  if [ -n "$tested" ]; then
    in_system "$root" tester 'cd ConformalSOM && bash Testing/run.sh' >"$root.tests.log" 2>&1 </dev/null || status=1
  fi
  printf "$row" "$suite" "$(version "$root" libvtk9-dev)" "$(version "$root" paraview)" \
    "$(version "$root" python3)" "$quickstart" "$figures" "$own" "$(tests "$root/$clone/build/dev/test.log")" \
    "$(tests "$root/$clone/build/paraview/test.log")"
done
exit "$status"
