#!/usr/bin/env bash
# publish_site.sh REMOTE [BRANCH]: make the web site, and push it to a branch (gh-pages) of a repository.
#
# REMOTE is what git push takes: a name such as origin, or an address. The branch then has the site and
# nothing else, in one more commit if something has changed. Install doxygen and texlive-base before to
# publish the reference, too.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
remote=${1:?"usage: publish_site.sh REMOTE [BRANCH]"} branch=${2:-gh-pages}
cd "$root"
address=$(git remote get-url "$remote" 2>/dev/null || echo "$remote")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

reference=()
html=build/dev/Documentation/html
if command -v doxygen >/dev/null && command -v bibtex >/dev/null; then
  cmake --preset dev >/dev/null && cmake --build --preset dev --target docs
  reference=(--reference "$html")
fi
/usr/bin/python3 Documentation/make_site.py "$work/site" "${reference[@]}"

git init --quiet "$work/branch"
cd "$work/branch"
if git fetch --quiet --depth 1 "$address" "$branch" 2>/dev/null; then
  git checkout --quiet -b "$branch" FETCH_HEAD
  git rm --quiet -r --ignore-unmatch .
else
  git checkout --quiet -b "$branch"
fi
cp -r "$work/site/." .
touch .nojekyll # pages are shown as they are
git add --all
if git diff --cached --quiet; then
  echo "Nothing has changed"
  exit 0
fi
name=$(git -C "$root" log -1 --format=%an) email=$(git -C "$root" log -1 --format=%ae)
git -c user.name="$name" -c user.email="$email" commit --quiet \
  -m "Publish the site of $(git -C "$root" rev-parse --short HEAD)"
git push --quiet "$address" "$branch"
echo "Pushed to $branch"
