#!/usr/bin/env bash
# make-source-package.sh: Debian's source package, in build/source-package.
#
# The last commit without its history is the original archive. CMake/Packages/debian becomes the folder debian: in files
# with the ending .in, names between @ are replaced, and the version is that of CMakeLists.txt. Who the maintainer is,
# is taken from DEBFULLNAME and DEBEMAIL, as Debian's tools do, and where the project is, from CONFORMALSOM_HOMEPAGE.
# dpkg-buildpackage in build/source-package/conformalsom-VERSION builds the packages; the network is not needed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
command -v dpkg-source >/dev/null || bash CMake/install-packages.sh dpkg-dev

version=$(sed -nE 's/^ +VERSION ([0-9.]+)$/\1/p' CMakeLists.txt)
suffix=${version%.*}
maintainer="${DEBFULLNAME:-ConformalSOM developers} <${DEBEMAIL:-conformalsom@example.org}>"
homepage=${CONFORMALSOM_HOMEPAGE:-https://example.org/conformalsom}

folder=build/source-package
rm -rf "$folder"
mkdir -p "$folder"
# The date of the commit, and no name in the archive: one commit makes one archive, everywhere.
git archive --format=tar --prefix="conformalsom-$version/" HEAD | gzip --best --no-name \
  >"$folder/conformalsom_$version.orig.tar.gz"
tar --extract --directory "$folder" --file "$folder/conformalsom_$version.orig.tar.gz"
cd "$folder/conformalsom-$version"
mv CMake/Packages/debian debian
find debian -name '*.in' | while read -r file; do
  sed --in-place -e "s|@PROJECT_VERSION@|$version|g" -e "s|@version_suffix@|$suffix|g" \
    -e "s|@CONFORMALSOM_MAINTAINER@|$maintainer|g" -e "s|@CONFORMALSOM_HOMEPAGE@|$homepage|g" "$file"
  mv "$file" "${file%.in}"
done
for file in debian/libconformalsom.*; do # of the library, whose package has the version in its name
  mv "$file" "debian/libconformalsom$suffix.${file#debian/libconformalsom.}"
done
cp -a debian ../debian # dpkg-source wants the original files outside of debian
cd ..
rm -rf "conformalsom-$version"
tar --extract --file "conformalsom_$version.orig.tar.gz"
mv debian "conformalsom-$version/debian"
dpkg-source --build "conformalsom-$version"
ls -- *.dsc
