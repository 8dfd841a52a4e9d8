#!/usr/bin/env bash
# run.sh [OPTION...] SUITE...: whether the README's commands work on fresh systems; run it as root.
#
# For each suite of Debian (bookworm, trixie, forky ...) makes a minimal system by debootstrap, clones
# the last commit into it, and there, as a user who is not root but may sudo, runs
# Examples/quickstart.sh and Testing/run.sh. Prints a row for each: whether the first command built and
# ran, whether its figures equal Testing/Systems/figures.txt, and how many tests passed, of VTK and of
# ParaView. Fails if a row is not all well.
#
#   --folder DIR   for the systems, 8 GB each, and for their logs; default build/systems
#   --cache DIR    keep packages and what ccache compiled there for the next run
#   --keep         go on in systems that are there, with the packages they have
#   --mirror URL   of Debian; default: that of this machine
set -euo pipefail
source_dir=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

folder=$source_dir/build/systems cache='' keep='' mirror=''
while [[ ${1:-} == --* ]]; do
  case $1 in
    --folder) folder=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --cache) cache=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --keep) keep=yes; shift ;;
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

home=home/tester
clone=$home/ConformalSOM

# make_system SUITE ROOT: with sudo, a user, and this machine's way to the network
make_system()
{
  # All suites that debootstrap may not know yet are made as sid is.
  debootstrap --variant=minbase --include=ca-certificates,sudo "$1" "$2" "$mirror" sid
  cp /etc/resolv.conf /etc/hosts "$2/etc"
  apt-config dump Acquire >"$2/etc/apt/apt.conf.d/01host"
  chroot "$2" useradd --create-home --shell /bin/bash tester
  echo 'tester ALL=(ALL) NOPASSWD: ALL' >"$2/etc/sudoers.d/tester"
  touch "$2/complete"
}

# within ROOT USER COMMAND: all mounts end with the command
within()
{
  root=$1 user=$2 command=$3 cache=${cache:+$cache/$(basename "$1")} unshare --mount bash -c '
    set -e
    for system in proc sys dev; do mount --rbind "/$system" "$root/$system"; done
    if [ -n "$cache" ]; then
      mount --bind "$cache/archives" "$root/var/cache/apt/archives"
      mount --bind "$cache/ccache" "$root/var/cache/ccache"
      command="export CCACHE_DIR=/var/cache/ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
        export CCACHE_SLOPPINESS=pch_defines,time_macros; $command"
    fi
    exec chroot "$root" su - "$user" --command "$command"'
}

# prepare SUITE ROOT
prepare()
{
  if [ -z "$keep" ] || [ ! -e "$2/complete" ]; then
    rm -rf --one-file-system "$2"
    make_system "$1" "$2"
  fi
  if [ -n "$cache" ]; then
    mkdir -p "$cache/$1/archives/partial" "$cache/$1/ccache" "$2/var/cache/ccache"
    chmod a+rwx "$cache/$1/ccache"
    within "$2" root 'apt-get update && apt-get install --yes --no-install-recommends ccache'
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

row='%-10s %-8s %-8s %-8s %-10s %-8s %-26s %s\n'
printf "$row" suite VTK ParaView Python quickstart figures tests "tests of the plugin"
status=0
for suite in "$@"; do
  root=$folder/$suite
  mkdir -p "$folder"
  said=$root.log
  prepare "$suite" "$root" >"$said" 2>&1
  said=''
  quickstart=ran figures=equal
  within "$root" tester 'cd ConformalSOM && bash Examples/quickstart.sh' \
    >"$root.quickstart.log" 2>&1 </dev/null || { quickstart=failed; status=1; }
  grep --extended-regexp '^(learned|smooth) ' "$root.quickstart.log" |
    cmp --quiet - "$source_dir/Testing/Systems/figures.txt" || { figures=differ; status=1; }
  within "$root" tester 'cd ConformalSOM && bash Testing/run.sh' >"$root.tests.log" 2>&1 </dev/null ||
    status=1
  printf "$row" "$suite" "$(version "$root" libvtk9-dev)" "$(version "$root" paraview)" \
    "$(version "$root" python3)" "$quickstart" "$figures" "$(tests "$root/$clone/build/dev/test.log")" \
    "$(tests "$root/$clone/build/paraview/test.log")"
done
exit "$status"
