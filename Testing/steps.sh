# steps.sh: what run.sh and check.sh do with the packages of Debian and the presets of CMake.
# Quiet but for summaries; what failed is shown.

launcher=()
if command -v ccache >/dev/null; then
  launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  export CCACHE_SLOPPINESS="${CCACHE_SLOPPINESS:-pch_defines,time_macros}" # for precompiled headers
fi

# dpkg, as root, does not wait for the disk after each file, which takes half of its time. If the machine stops
# meanwhile, packages are to be installed again.
export DPKG_FORCE=unsafe-io

# install PACKAGE...: what builds with tests and their programs want, and these
install()
{
  install_libraries "$@"
  install_programs
}

# install_libraries PACKAGE...: what builds with tests want, and these
install_libraries()
{
  bash CMake/install-packages.sh cmake ninja-build g++ libvtk9-dev python3-vtk9 python3-numpy \
    libeigen3-dev libexpat1-dev zlib1g-dev libmeshoptimizer-dev libgtest-dev libbenchmark-dev libboost-dev \
    openmpi-bin "$@"
}

# install_programs: what tests call
install_programs()
{
  bash CMake/install-packages.sh assimp-utils connectome-workbench gdal-bin python3-gdal python3-markdown mypy \
    libjs-three chromium f3d man-db mandoc xvfb xauth libgl1-mesa-dri
  if apt-cache show python3-pyvista >/dev/null 2>&1; then # Debian has it since 13
    bash CMake/install-packages.sh python3-pyvista
  fi
}

# install_paraview
install_paraview()
{
  bash CMake/install-packages.sh paraview paraview-dev libqt5svg5
}

# logged LOG TITLE COMMAND...: run with all output in the log, and show its end if it fails
logged()
{
  local log=$1 title=$2
  shift 2
  mkdir -p "$(dirname "$log")"
  echo "$title"
  if ! "$@" >"$log" 2>&1; then
    tail -n 60 "$log"
    echo "Failed: $title; all of the output is in $log" >&2
    return 1
  fi
}

# configure PRESET [OPTION...]: of cmake
configure()
{
  local preset=$1
  shift
  logged "build/$preset/configure.log" "Configuring build/$preset" cmake --preset "$preset" "${launcher[@]}" "$@"
}

# build PRESET [TARGET...]
build()
{
  local preset=$1
  shift
  logged "build/$preset/build.log" "Building ${*:-everything} in build/$preset" \
    cmake --build --preset "$preset" ${1:+--target "$@"}
}

# on_own_screen COMMAND...
on_own_screen()
{
  # Without -noreset the server starts anew whenever no window is open, and meanwhile refuses some.
  # Of two that start at once, both may find the same number free: each script starts from its own.
  xvfb-run --auto-servernum --server-num="$((100 + $$ % 30000))" \
    --server-args="-noreset -screen 0 1280x1024x24" "$@"
}

# each COMMAND ARGUMENT...: run the command with each argument alone, as many at once as there are processors.
# Arguments with which it fails are put into the array failed.
each()
{
  local command=$1 argument pid
  local -A arguments=()
  shift
  failed=()
  for argument in "$@"; do
    # wait -n also returns for jobs that ended before it was called.
    while [ "$(jobs -rp | wc -l)" -ge "$(nproc)" ]; do
      wait -n || true
    done
    "$command" "$argument" &
    arguments[$!]=$argument
  done
  for pid in "${!arguments[@]}"; do
    wait "$pid" || failed+=("${arguments[$pid]}")
  done
}

# run_tests PRESET [ARGUMENT...]: of ctest
run_tests()
{
  local preset=$1 log=build/$1/test.log status=0
  shift
  echo "Testing in build/$preset"
  # Tests write thousands of small files: in memory they take a fifth of the time.
  if [ -z "${TMPDIR:-}" ] && [ -w /dev/shm ] && [ "$(df --output=avail -k /dev/shm | tail -n 1)" -gt 4000000 ]; then
    local -x TMPDIR=/dev/shm
  fi
  on_own_screen ctest --preset "$preset" -j"$(($(nproc) + 1))" "$@" >"$log" 2>&1 || status=$? # some of them wait
  if [ "$status" -ne 0 ]; then
    cat "$log"
  else
    sed -n '/% tests passed/,$p' "$log"
  fi
  return "$status"
}
