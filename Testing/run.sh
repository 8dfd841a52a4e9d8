#!/usr/bin/env bash
# run.sh: install what is missing, build with tests, run every test. Enough on a fresh Debian 12.
#
# Quiet until the summary; what failed is shown in full. Arguments go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash CMake/install-packages.sh cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-numpy \
  libeigen3-dev libexpat1-dev zlib1g-dev libgtest-dev libbenchmark-dev libboost-dev assimp-utils xvfb \
  xauth libgl1-mesa-dri openmpi-bin

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
mkdir -p build/dev
echo "Building into build/dev"
if ! { cmake --preset dev "${launcher[@]}" && cmake --build --preset dev; } >build/dev/build.log 2>&1
then
  tail -n 60 build/dev/build.log
  echo "The build failed; all of its output is in build/dev/build.log" >&2
  exit 1
fi

echo "Testing"
status=0
# Without -noreset the server starts anew whenever no window is open, and meanwhile refuses some.
xvfb-run --auto-servernum --server-args="-noreset -screen 0 1280x1024x24" \
  ctest --preset dev -j2 "$@" >build/dev/test.log 2>&1 || status=$?
if [ "$status" -ne 0 ]; then
  cat build/dev/test.log
else
  sed -n '/% tests passed/,$p' build/dev/test.log
fi
exit "$status"
