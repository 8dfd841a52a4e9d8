#!/usr/bin/env bash
# check.sh [CHECK...]: what a pull request must pass, on Debian 12; what is missing is installed.
#
#   format  C++ is laid out as .clang-format says
#   tidy    clang-tidy finds nothing in the libraries (.clang-tidy)
#   docs    the pages build without a warning, with all citations and links
#   asan    all tests but those in Python, under AddressSanitizer and UndefinedBehaviorSanitizer
#   tests   all tests, as Testing/run.sh
#   wheel   the wheel of all classes passes the tests of Python
#
# Without arguments all of them. The jobs of .github/workflows/ci.yml are these.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/steps.sh

llvm=14 # Debian 12's. Other versions lay out and find otherwise.

check_format()
{
  bash CMake/install-packages.sh "clang-format-$llvm"
  find Examples Filters IO Testing \( -name '*.cxx' -o -name '*.h' \) -print0 |
    xargs -0 "clang-format-$llvm" --dry-run --Werror ||
    { echo "To repair: clang-format-$llvm -i FILE..." >&2; return 1; }
}

check_tidy()
{
  install "clang-tidy-$llvm"
  configure dev
  echo "Looking through Filters and IO"
  "run-clang-tidy-$llvm" -quiet -p build/dev "^$PWD/(Filters|IO)/" >build/dev/tidy.log 2>&1 || {
    grep 'error: ' build/dev/tidy.log | sort -u
    echo "clang-tidy finds this; all of its output is in build/dev/tidy.log" >&2
    return 1
  }
}

check_docs()
{
  install doxygen texlive-base
  configure dev
  build dev docs
}

check_asan()
{
  install
  configure asan
  build asan
  run_tests asan
}

check_tests()
{
  bash Testing/run.sh
}

check_wheel()
{
  install
  bash Testing/Wheel/run.sh --all
}

all=(format docs tidy asan tests wheel)
for check in "$@"; do
  [[ " ${all[*]} " == *" $check "* ]] || { echo "No check $check; there are ${all[*]}" >&2; exit 2; }
done
if [ "$#" -eq 1 ]; then
  "check_$1"
  exit
fi
failed=()
for check in "${@:-${all[@]}}"; do
  echo "== $check"
  bash Testing/check.sh "$check" || failed+=("$check")
done
[ "${#failed[@]}" -eq 0 ] || { echo "Failed: ${failed[*]}" >&2; exit 1; }
echo "All is well"
