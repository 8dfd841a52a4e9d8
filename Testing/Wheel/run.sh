#!/usr/bin/env bash
# run.sh [--all] [PYTHON]: make the wheel, install it in an empty virtual environment, and run tests there.
#
# Without --all, the wheel has the classes of the preset quickstart-files, compiled with -O1, and only the
# tests of the wheel and of the command are run. With it, the wheel is the one that users get, and all tests
# of Python are run. PYTHON is Debian's python3 if it is not given.
# Writes build/wheel: the source distribution and the wheel in dist, logs, environments. The wheel is made of
# the source distribution. The wheel vtk-sdk is that of Kitware's index, or where that is not reached the
# one that make_vtk_sdk.py makes. Nothing of build/dev fits it: its strings are those of older GCC
# (_GLIBCXX_USE_CXX11_ABI=0). Without PyPI, all of it is skipped.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
source Testing/steps.sh

# All tests share a screen: of two that start at once, both may find the same screen free.
if [ -z "${CONFORMALSOM_HAS_SCREEN:-}" ]; then
  CONFORMALSOM_HAS_SCREEN=yes on_own_screen bash "$PWD/Testing/Wheel/run.sh" "$@"
  exit
fi

all=''
if [ "${1:-}" = --all ]; then
  all=yes
  shift
fi
python=${1:-/usr/bin/python3}
folder=$PWD/build/wheel
log=$folder/log
mkdir -p "$folder"
export PIP_DISABLE_PIP_VERSION_CHECK=1 PYTHONDONTWRITEBYTECODE=1

skip()
{
  echo "The tests of the wheel are skipped: $1"
  exit 0
}

if [ "$python" = /usr/bin/python3 ]; then
  bash CMake/install-packages.sh python3-venv python3-dev g++ || skip "python3-venv and python3-dev are missing"
fi
"$python" -m venv "$folder/tools" >"$log" 2>&1 || skip "$python has no venv"
tools=$folder/tools/bin/python
timeout 300 "$tools" -m pip install --quiet --retries 1 --timeout 20 build >>"$log" 2>&1 || skip "PyPI cannot be reached"
tag=$("$tools" -c 'import sys; print("cp%d%d" % sys.version_info[:2])')

# find_sdk: the wheel vtk-sdk into sdk
find_sdk()
{
  local sdk
  sdk=$(sed -n 's/^  "\(vtk-sdk==[^"]*\)".*/\1/p' pyproject.toml)
  mkdir -p "$folder/sdk"
  compgen -G "$folder/sdk/${sdk/-sdk==/_sdk-}-$tag-*.whl" >/dev/null ||
    "$tools" -m pip download --quiet --no-deps --dest "$folder/sdk" --only-binary :all: \
      --retries 0 --timeout 20 --extra-index-url https://wheels.vtk.org "$sdk" ||
    nice "$tools" Testing/Wheel/make_vtk_sdk.py "$folder/sdk"
}
logged "$folder/sdk.log" "Finding VTK's wheel SDK" find_sdk ||
  skip "neither Kitware's index nor Debian has the wheel SDK of this VTK"

# classes: those of the preset quickstart-files
classes()
{
  "$tools" -c 'if True:
    import json
    presets = json.load(open("CMakePresets.json"))["configurePresets"]
    [preset] = (preset for preset in presets if preset["name"] == "quickstart-files")
    print(preset["cacheVariables"]["CONFORMALSOM_CLASSES"])'
}

# install_requirements: what pyproject.toml requires for building
install_requirements()
{
  "$tools" -c 'if True:
    import re
    text = re.search(r"requires = \[(.*?)\n\]", open("pyproject.toml").read(), re.S)[1]
    print(*re.findall(r"\"([^\"]+)\"", text), sep="\n")' >"$folder/requirements.txt"
  PIP_FIND_LINKS="$folder/sdk ${PIP_FIND_LINKS:-}" "$tools" -m pip install --requirement "$folder/requirements.txt"
}

# Without --all, all paths are the same in each run, for the compiler cache: that of the unpacked source
# distribution, and those of the packages to build with. With --all, pip puts these into a new folder, as for users.
make_wheel()
{
  rm -rf "$folder/dist" "$folder/source" "$folder/made"
  install_requirements || return
  "$tools" -m build --sdist --no-isolation --outdir "$folder/dist" . || return
  mkdir -p "$folder/source"
  tar --extract --file "$folder"/dist/*.tar.gz --directory "$folder/source" --strip-components 1 || return
  local options=()
  if [ -z "$all" ]; then
    options=(--no-build-isolation
      --config-settings=cmake.define.CMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG"
      --config-settings=cmake.define.CONFORMALSOM_CLASSES="$(classes)")
  fi
  PIP_FIND_LINKS="$folder/sdk ${PIP_FIND_LINKS:-}" \
    CMAKE_CXX_COMPILER_LAUNCHER=$(command -v ccache || true) \
    "$tools" -m pip wheel "$folder/source" --no-deps --wheel-dir "$folder/dist" -v \
    --config-settings=build-dir="$folder/made" "${options[@]}"
}
logged "$folder/build.log" "Building the wheel in build/wheel" make_wheel

# What a user does, and tests of what is installed.
"$python" -m venv --clear "$folder/venv"
user=$folder/venv/bin/python
logged "$folder/install.log" "Installing the wheel" "$user" -m pip install "$folder"/dist/*"$tag"*.whl
export CONFORMALSOM_COMMAND=$folder/venv/bin/conformalsom PYTHONPATH=$PWD/Examples/Python
export CONFORMALSOM_PICTURES=$folder/pictures CONFORMALSOM_INSTALLED_WHEEL=1
export CONFORMALSOM_SCAN_DIR=${CONFORMALSOM_SCAN_DIR:-$PWD/../shared/data}
number=0 all_failed=()

# run_file "TEST [CLASS...]": a file of tests, or classes of it
run_file()
{
  local words
  read -ra words <<<"$1"
  logged "$folder/$(basename "${words[0]}" .py)${words[1]:-}.log" "Testing the wheel by $1" "$user" "${words[@]}"
}

run_files()
{
  each run_file "$@"
  number=$((number + $#))
  all_failed+=("${failed[@]}")
}

if [ -z "$all" ]; then
  run_files Testing/Wheel/test_wheel.py "Testing/Python/test_command.py TestCommand" \
    "Testing/Python/test_command.py TestScripts TestFormats TestColors" # as long as the other half
else
  others=(Testing/Python/test_{functions,pyvista,stubs}.py) # also use packages that the wheel does not need
  mapfile -t files < <(ls Testing/Python/test_*.py | grep --invert-match --fixed-strings \
    "$(printf '%s\n' "${others[@]}" test_manual)") # the wheel has no manual pages
  run_files Testing/Wheel/test_wheel.py "${files[@]}" Testing/Python/test_functions.py
  logged "$folder/install.log" "Installing PyVista, trimesh and mypy" "$user" -m pip install pyvista trimesh mypy
  run_files "${others[@]}"
fi
[ "${#all_failed[@]}" -eq 0 ] || { echo "Failed with the wheel: ${all_failed[*]}" >&2; exit 1; }
echo "The wheel passes $number runs of tests"
