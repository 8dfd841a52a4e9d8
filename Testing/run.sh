#!/usr/bin/env bash
# run.sh: install what is missing, build with tests, run every test. Enough on a fresh Debian. Of the wheel,
# which is compiled once more for another VTK, only what the command uses is built and tested, and only where
# PyPI can be reached; check.sh wheel tests all of it.
#
# Quiet until the summaries, of VTK, of ParaView and of the wheel; what failed is shown in full. Arguments
# go to ctest.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/steps.sh

install_libraries
{
  install_programs
  install_paraview
} & # while the libraries are compiled; what fails is tried again before it is needed
configure dev -DCMAKE_UNITY_BUILD=ON # saves up to half of the time to compile
build dev
wait "$!" || true
install_programs
bash Testing/Wheel/run.sh & # meanwhile, since many of its steps use one processor or the network
wheel=$!
status=0
run_tests dev "$@" || status=$?

# test_plugin [ARGUMENT...]: of ctest
test_plugin()
{
  install_paraview ||
    { echo "The tests of the plugin are skipped: ParaView is not installed and could not be"; return 0; }
  bash CMake/make-paraview-prefix.sh build/paraview-prefix &&
    configure paraview -DCONFORMALSOM_CORE_FOLDER="$PWD/build/dev" && # half of the plugin's time to compile
    build paraview &&
    run_tests paraview "$@"
}

test_plugin "$@" || status=$?
wait "$wheel" || status=$?
exit "$status"
