# Environment of tests that start several processes: Open MPI, 4 and 5, runs as root and has more
# processes than cores, as in containers.
set(conformal_mpi_environment
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe")

# conformal_add_tests(<layer> LIBRARIES <library>... [PRECOMPILE <header>...])
#
# One GoogleTest program of all Test<unit>.cxx in this folder and those below, and a CTest test
# <layer>.<unit> for each. A unit's suites start with its name, by which they are chosen; a choice of
# none would pass unseen, so it fails here.
function (conformal_add_tests layer)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;PRECOMPILE")
  set(program "conformal${layer}Tests")
  file(GLOB_RECURSE sources RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "Test*.cxx")
  add_executable(${program} ${sources})
  target_link_libraries(${program}
    PRIVATE ${arg_LIBRARIES} GTest::gtest_main conformalBuild conformalWarnings)
  # Two thirds of the time of -O2 to compile; the work is done in the libraries.
  target_compile_options(${program} PRIVATE $<$<CONFIG:RelWithDebInfo>:-O1>)
  # Half of the time of most tests to compile.
  target_precompile_headers(${program} PRIVATE
    <gtest/gtest.h> <algorithm> <cmath> <functional> <string> <vector> ${arg_PRECOMPILE})
  conformal_unite_folders(${program})
  foreach (source IN LISTS sources)
    get_filename_component(unit "${source}" NAME_WE)
    string(REGEX REPLACE "^Test" "" unit "${unit}")
    add_test(NAME ${layer}.${unit} COMMAND ${program} --gtest_filter=${unit}.*)
    set_tests_properties(${layer}.${unit} PROPERTIES
      FAIL_REGULAR_EXPRESSION "Running 0 tests"
      SKIP_REGULAR_EXPRESSION "SKIPPED.*\n.*PASSED  . 0 tests")
  endforeach ()
endfunction ()
