#!/usr/bin/env bash
# make-packages.sh: packages of this Debian, and the archive of the sources, in build/package/packages.
#
# Installs what is missing, and builds the libraries against VTK and the plugin against ParaView. Who
# the maintainer is, is taken from DEBFULLNAME and DEBEMAIL, as Debian's tools do.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

bash CMake/install-packages.sh cmake ninja-build g++ dpkg-dev file libvtk9-dev python3-vtk9 \
  libeigen3-dev libexpat1-dev zlib1g-dev libmeshoptimizer-dev paraview paraview-dev libqt5svg5
bash CMake/make-paraview-prefix.sh build/paraview-prefix
rm -rf build/package/packages
cmake --preset package
cmake --build --preset package
cmake --preset package-paraview -DCONFORMALSOM_CORE_FOLDER="$PWD/build/package" # half of the time to compile
cmake --build --preset package-paraview
cmake --preset package # adds the plugin to the packages
cmake --build build/package --target package package_source
rm -r build/package/packages/_CPack_Packages
ls build/package/packages/*.deb build/package/packages/*.tar.gz
