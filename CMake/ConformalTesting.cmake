# Environment of tests that start several processes: Open MPI, 4 and 5, runs as root and has more
# processes than cores, as in containers.
set(conformal_mpi_environment
  "OMPI_ALLOW_RUN_AS_ROOT=1"
  "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1"
  "OMPI_MCA_rmaps_base_oversubscribe=1"
  "PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe")

# conformal_add_tests(<layer> LIBRARIES <library>... TESTS <unit>...)
#
# One GoogleTest program for a layer, one CTest test for each Test<unit>.cxx, named
# <layer>.<unit>; one in a folder is written <folder>/<unit>. A unit's suites start with its name,
# by which they are chosen; a choice of none would pass unseen, so it fails here.
function (conformal_add_tests layer)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES;TESTS")
  set(program "conformal${layer}Tests")
  list(TRANSFORM arg_TESTS REPLACE "([^/]+)$" "Test\\1.cxx" OUTPUT_VARIABLE sources)
  add_executable(${program} ${sources})
  target_link_libraries(${program}
    PRIVATE ${arg_LIBRARIES} GTest::gtest_main conformalBuild conformalWarnings)
  foreach (test IN LISTS arg_TESTS)
    get_filename_component(unit "${test}" NAME)
    add_test(NAME ${layer}.${unit} COMMAND ${program} --gtest_filter=${unit}.*)
    set_tests_properties(${layer}.${unit} PROPERTIES
      FAIL_REGULAR_EXPRESSION "Running 0 tests"
      SKIP_REGULAR_EXPRESSION "SKIPPED.*\n.*PASSED  . 0 tests")
  endforeach ()
endfunction ()
