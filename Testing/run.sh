#!/usr/bin/env bash
# run.sh: install what is missing, build with tests, run every test. Enough on a fresh Debian. The wheel
# is tested by check.sh wheel, since it is compiled for another VTK.
#
# Quiet until the summaries, one of VTK and one of ParaView; what failed is shown in full. Arguments
# go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/steps.sh

install
configure dev
build dev
failed=0
run_tests dev "$@" || failed=$?

if bash CMake/install-packages.sh paraview paraview-dev libqt5svg5; then
  bash CMake/make-paraview-prefix.sh build/paraview-prefix
  configure paraview -DCONFORMALSOM_CORE_FOLDER="$PWD/build/dev" # half of the plugin's time to compile
  build paraview
  run_tests paraview "$@" || failed=$?
else
  echo "The tests of the plugin are skipped: ParaView is not installed and could not be"
fi
exit "$failed"
