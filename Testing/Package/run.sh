#!/usr/bin/env bash
# run.sh [OPTION...] SUITE...: whether the packages work on fresh systems; run it as root.
#
# For each suite of Debian (bookworm, trixie ...) makes minimal systems by debootstrap: one that builds
# the packages of the last commit by CMake/make-packages.sh, one where those for VTK are installed, and
# one with the plugin, since Debian's Python packages of VTK and of ParaView exclude each other. In the
# latter two, a user without rights takes the first steps in Python, in C++ and with pvbatch, with no
# variable set. Ends with lintian's errors and a row for each suite; fails if a step does.
#
#   --packages DIR  take these packages instead of building some; for one suite
#   --folder DIR    for the systems, 10 GB each suite, and their logs; default build/package-systems
#   --mirror URL    of Debian; default: that of this machine
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/../Systems/debian.sh"

folder=$source_dir/build/package-systems packages='' mirror=''
while [[ ${1:-} == --* ]]; do
  case $1 in
    --packages) packages=$(realpath "$2"); shift 2 ;;
    --folder) folder=$(realpath --canonicalize-missing "$2"); shift 2 ;;
    --mirror) mirror=$2; shift 2 ;;
    *) echo "No option $1" >&2; exit 2 ;;
  esac
done
[ "$#" -gt 0 ] || usage "${BASH_SOURCE[0]}"
require_debootstrap lintian

# fresh SUITE ROOT: a copy of a minimal system, made once a run
fresh()
{
  local base=$folder/$1.base
  if [ ! -e "$base/complete" ]; then
    make_system "$1" "$base"
  fi
  rm -rf --one-file-system "$2"
  cp --archive --reflink=auto "$base" "$2"
  within "$2" root 'apt-get --quiet update'
}

# build_packages SUITE: into $folder/SUITE.packages
build_packages()
{
  local root=$folder/$1.build
  fresh "$1" "$root"
  git clone --quiet --no-hardlinks "$source_dir" "$root/root/ConformalSOM"
  within "$root" root 'bash ConformalSOM/CMake/make-packages.sh'
  rm -rf "$folder/$1.packages"
  cp --recursive "$root/root/ConformalSOM/build/package/packages" "$folder/$1.packages"
  rm -rf --one-file-system "$root"
}

# install_packages SUITE ROOT FROM PACKAGE...: our packages of a folder, and others by name
install_packages()
{
  local root=$2 from=$3 names=() name
  fresh "$1" "$root"
  shift 3
  for name in "$@"; do
    if compgen -G "$from/${name}_*.deb" >/dev/null; then
      cp "$from/$name"_*.deb "$root/opt"
      names+=("/opt/$(basename "$from/$name"_*.deb)")
    else
      names+=("$name")
    fi
  done
  cp --recursive "$source_dir/Examples/Cxx/ConformalTexture" \
    "$source_dir/Testing/Package/"first_steps*.py "$root/home/tester"
  within "$root" root "apt-get install --yes --no-install-recommends ${names[*]}"
  chroot "$root" chown --recursive tester: /home/tester
}

# step LOG ROOT COMMAND: as a user, and say how it went
step()
{
  if within "$2" tester "$3" >"$1" 2>&1 </dev/null; then
    echo works
  else
    echo FAILS
  fi
}

# What failed last is shown; not by ||, after which bash goes on within a function.
said=''
trap '[ $? -eq 0 ] || [ -z "$said" ] || tail "$said" >&2' EXIT

rows=()
for suite in "$@"; do
  mkdir -p "$folder"
  log=$folder/$suite
  from=$packages
  if [ -z "$from" ]; then
    said=$log.build.log
    build_packages "$suite" >"$said" 2>&1
    from=$folder/$suite.packages
  fi
  library=$(basename "$from"/libconformalsom[0-9]*.deb | sed 's/_.*//')
  said=$log.vtk.log
  install_packages "$suite" "$log.vtk" "$from" "$library" libconformalsom-dev python3-conformalsom \
    cmake make g++ >"$said" 2>&1
  python=$(step "$log.python.log" "$log.vtk" "python3 first_steps.py && conformalsom --help")
  cxx=$(step "$log.cxx.log" "$log.vtk" \
    'cmake -S ConformalTexture -B consumer && cmake --build consumer &&
     consumer/ConformalTexture painted.vtp | tee says && grep "116642 points" says')
  said=$log.paraview.log
  install_packages "$suite" "$log.paraview" "$from" paraview-conformalsom python3-paraview >"$said" 2>&1
  pvbatch=$(step "$log.pvbatch.log" "$log.paraview" 'pvbatch first_steps_paraview.py')
  said='' lintian=clean
  lintian --allow-root --fail-on error "$from"/*.deb >"$log.lintian.log" 2>&1 || lintian=ERRORS
  grep '^E:' "$log.lintian.log" || true
  rows+=("$(printf '%-10s %-8s %-8s %-8s %s' "$suite" "$python" "$cxx" "$pvbatch" "$lintian")")
done
printf '%-10s %-8s %-8s %-8s %s\n' suite Python C++ pvbatch lintian
printf '%s\n' "${rows[@]}"
[[ ${rows[*]} != *FAILS* && ${rows[*]} != *ERRORS* ]]
