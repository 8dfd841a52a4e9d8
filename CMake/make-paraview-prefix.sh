#!/usr/bin/env bash
# make-paraview-prefix.sh FOLDER: a prefix in which CMake finds all of Debian's ParaView.
#
# The files that CMake asks for are in the packages paraview, paraview-dev and python3-paraview. The
# last one can be installed beside VTK's own python3-vtk9 only since ParaView 6, so it is fetched and
# unpacked if it is not installed, and all three are put together by links. Nothing of the system is
# changed; a finished prefix is left alone.
set -euo pipefail

prefix=${1:?"usage: make-paraview-prefix.sh FOLDER"}
[ ! -e "$prefix/complete" ] || exit 0
rm -rf "$prefix"
mkdir -p "$prefix/download"
prefix=$(cd "$prefix" && pwd)

mkdir "$prefix/python3-paraview"
if dpkg-query --show --showformat='${db:Status-Status}' python3-paraview 2>/dev/null | grep -qx installed; then
  dpkg --listfiles python3-paraview | grep --extended-regexp '^/usr/(bin|lib)/' | sed 's|^/||' |
    tar --create --directory / --no-recursion --files-from - | tar --extract --directory "$prefix/python3-paraview"
else
  (cd "$prefix/download" && apt-get -qq download python3-paraview 2>"$prefix/download/log") ||
    { cat "$prefix/download/log" >&2; exit 1; }
  dpkg-deb --extract "$prefix"/download/python3-paraview_*.deb "$prefix/python3-paraview"
fi

# Newer packages name Python's modules with the interpreter's suffix, and CMake asks for them without.
find "$prefix/python3-paraview" -name '*.cpython-*.so' | while read -r module; do
  ln -s "$(basename "$module")" "${module%.cpython-*}.so"
done

# CMake's files say where all others are by their own place: they are copied, the others linked.
libraries=lib/$(gcc -print-multiarch)
mkdir -p "$prefix/bin" "$prefix/include" "$prefix/$libraries/cmake" "$prefix/$libraries/vtk/hierarchy"
cp --recursive /usr/"$libraries"/cmake/paraview-* "$prefix/$libraries/cmake"
ln -s /usr/include/paraview-* "$prefix/include"
ln -s /usr/"$libraries"/paraview-* "$prefix/$libraries"
hierarchy=$prefix/python3-paraview/usr/$libraries/vtk/hierarchy/ParaView
[ -e "$hierarchy" ] || hierarchy=/usr/$libraries/vtk/hierarchy/ParaView # since ParaView 6
ln -s "$hierarchy" "$prefix/$libraries/vtk/hierarchy"
ln -s "$prefix/python3-paraview/usr/lib/python3" "$prefix/lib"
dpkg --listfiles paraview paraview-dev | sort --unique |
  grep --extended-regexp "^/usr/($libraries/[^/]+\.(so|a)(\..*)?|bin/.+)$" |
  while read -r file; do
    ln -s "$file" "$prefix/${file#/usr/}"
  done
ln -s "$prefix"/python3-paraview/usr/bin/* "$prefix/bin"
rm -r "$prefix/download"
touch "$prefix/complete"
