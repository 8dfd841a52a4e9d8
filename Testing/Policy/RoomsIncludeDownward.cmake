# The rooms of the core know only those that they are built on, and no two units (a header and its
# source) include each other, not even through others. Tests have the rooms of what they test.
cmake_minimum_required(VERSION 3.18)

set(rooms Base Mesh TriangleMap Search Cloud Linear Sphere SphereMap Hull Surface Learn Texture Measure)
set(below_Base)
set(below_Mesh Base)
set(below_TriangleMap Base)
set(below_Search Base)
set(below_Cloud Base Mesh Search)
set(below_Linear Base Mesh)
set(below_Sphere Base Mesh Search)
set(below_SphereMap Base Mesh Linear Sphere)
set(below_Hull Base Mesh Search Cloud)
set(below_Surface Base Mesh TriangleMap Search Cloud Linear Sphere)
set(below_Learn Base Mesh TriangleMap Search Cloud Linear Sphere SphereMap Hull)
set(below_Texture Base Mesh Search Sphere)
set(below_Measure Base Mesh Search Sphere)

include("${CMAKE_CURRENT_LIST_DIR}/IncludeDownward.cmake")
check_rooms("${SOURCE_DIR}/Filters/Numerics")

file(GLOB_RECURSE tests RELATIVE "${SOURCE_DIR}/Testing/Numerics" "${SOURCE_DIR}/Testing/Numerics/Test*.cxx")
foreach (test IN LISTS tests)
  string(REGEX REPLACE "Test([A-Za-z0-9]+)\\.cxx$" "\\1.h" header "${test}")
  if (NOT EXISTS "${SOURCE_DIR}/Filters/Numerics/${header}")
    message(SEND_ERROR "Testing/Numerics/${test} tests no ${header} of Filters/Numerics")
  endif ()
endforeach ()
