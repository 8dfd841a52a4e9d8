#!/usr/bin/env bash
# run.sh: install what is missing, build with tests, run every test. Enough on a fresh Debian 12.
#
# Quiet until the summaries, one of VTK and one of ParaView; what failed is shown in full. Arguments
# go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

# build_and_test PRESET ARGUMENT...
build_and_test()
{
  local preset=$1 folder=build/$1 status=0
  shift
  mkdir -p "$folder"
  echo "Building into $folder"
  if ! { cmake --preset "$preset" "${launcher[@]}" && cmake --build --preset "$preset"; } \
    >"$folder/build.log" 2>&1
  then
    tail -n 60 "$folder/build.log"
    echo "The build failed; all of its output is in $folder/build.log" >&2
    exit 1
  fi

  echo "Testing"
  # Without -noreset the server starts anew whenever no window is open, and meanwhile refuses some.
  xvfb-run --auto-servernum --server-args="-noreset -screen 0 1280x1024x24" \
    ctest --preset "$preset" -j2 "$@" >"$folder/test.log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    cat "$folder/test.log"
  else
    sed -n '/% tests passed/,$p' "$folder/test.log"
  fi
  return "$status"
}

bash CMake/install-packages.sh cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-numpy \
  libeigen3-dev libexpat1-dev zlib1g-dev libgtest-dev libbenchmark-dev libboost-dev assimp-utils xvfb \
  xauth libgl1-mesa-dri openmpi-bin
failed=0
build_and_test dev "$@" || failed=$?

if bash CMake/install-packages.sh paraview paraview-dev libqt5svg5; then
  bash CMake/make-paraview-prefix.sh build/paraview-prefix
  build_and_test paraview "$@" || failed=$?
else
  echo "The tests of the plugin are skipped: ParaView is not installed and could not be"
fi
exit "$failed"
