#!/usr/bin/env bash
# paraview.sh [ARGUMENT...]: ParaView with our plugin, on Debian; arguments go to ParaView.
#
# Installs what is missing and builds the plugin into build/paraview. Documentation/ParaView.md has
# what comes next, and how to run pvserver, pvpython and pvbatch.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# libvtk9-dev brings headers of other libraries that paraview-dev wants and does not ask for.
bash "$root/CMake/install-packages.sh" cmake ninja-build g++ libvtk9-dev libeigen3-dev \
  libexpat1-dev zlib1g-dev libmeshoptimizer-dev paraview paraview-dev libqt5svg5
bash "$root/CMake/make-paraview-prefix.sh" "$root/build/paraview-prefix"

bash "$root/CMake/build.sh" paraview build/paraview

plugins=$root/build/paraview/plugins
export PV_PLUGIN_PATH=$plugins${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}
exec paraview "$@"
