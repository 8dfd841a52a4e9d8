#!/usr/bin/env bash
# check.sh [CHECK...]: what a pull request must pass, on Debian 12; what is missing is installed.
#
#   format  C++ is laid out as .clang-format says
#   tidy    clang-tidy finds nothing in the libraries (.clang-tidy)
#   docs    the pages build without a warning, with all citations and links
#   asan    all tests but those in Python, under AddressSanitizer and UndefinedBehaviorSanitizer, in eight parts;
#           parts that have passed are not run again by the next call, unless something was compiled since
#   tests   all tests, as Testing/run.sh
#   wheel   the wheel of all classes passes the tests of Python
#
# Without arguments all of these. One more takes hours:
#
#   fuzz    each fuzzer finds nothing in FUZZ_SECONDS (600); fuzzers that have passed are not run again, as for asan
#
# The jobs of .github/workflows/ci.yml are these.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source Testing/steps.sh

llvm=14 # Debian 12's. Other versions lay out and find otherwise.
clang=(clang "libclang-rt-$llvm-dev") # with what its sanitizers need

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
  configure tidy # without precompiled headers, which clang cannot read after GCC has made them
  echo "Looking through Filters and IO"
  "run-clang-tidy-$llvm" -quiet -p build/tidy "^$PWD/(Filters|IO)/" >build/tidy/tidy.log 2>&1 || {
    grep 'error: ' build/tidy/tidy.log | sort -u
    echo "clang-tidy finds this; all of its output is in build/tidy/tidy.log" >&2
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
  install "${clang[@]}"
  configure asan
  build asan
  forget_passed asan
  local part failed=0
  for part in {1..8}; do
    once asan "tests-$part" run_tests asan -I "$part,,8" || failed=1
  done
  return "$failed"
}

# forget_passed PRESET: if the last build has compiled something
forget_passed()
{
  grep -q "no work to do" "build/$1/build.log" || rm -rf "build/$1/passed"
}

# once PRESET NAME COMMAND...: run, unless it has passed before
once()
{
  local passed="build/$1/passed/$2"
  if [ -e "$passed" ]; then
    echo "$2 has passed before"
    return
  fi
  "${@:3}" && mkdir -p "$(dirname "$passed")" && touch "$passed"
}

# fuzz FILE: a corpus of Testing/Fuzz/Corpus
fuzz()
{
  local unit found program=build/fuzz/Testing/Fuzz/FuzzClass
  # libFuzzer starts with short inputs, and a slow class would get no others: 16 bytes in a minute.
  local lengths=(-len_control=0 -max_len=1000)
  unit="$(basename "$1" .inputs)"
  found="$PWD/build/fuzz/found/$unit" # writers are run in another folder
  if [ -x "build/fuzz/Testing/Fuzz/Fuzz$unit" ]; then
    program="build/fuzz/Testing/Fuzz/Fuzz$unit"
    lengths=()
  fi
  python3 Testing/Fuzz/corpus.py unpack "$1" "$found"
  CONFORMALSOM_FUZZED_CLASS="vtk$unit" logged "build/fuzz/$unit.log" "Fuzzing $unit" "$program" "${lengths[@]}" \
    -max_total_time="${FUZZ_SECONDS:-600}" -artifact_prefix="$PWD/build/fuzz/$unit-" "$found"
}

fuzz_once()
{
  once fuzz "$(basename "$1" .inputs)" fuzz "$1"
}

check_fuzz()
{
  install "${clang[@]}"
  configure fuzz
  build fuzz
  forget_passed fuzz
  each fuzz_once Testing/Fuzz/Corpus/*.inputs
  [ "${#failed[@]}" -eq 0 ]
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
  [[ " ${all[*]} fuzz " == *" $check "* ]] || { echo "No check $check; there are ${all[*]} fuzz" >&2; exit 2; }
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
