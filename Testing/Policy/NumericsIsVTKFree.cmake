# The core and the parsers are used and tested without VTK: no source of theirs includes it.
cmake_minimum_required(VERSION 3.18)
file(GLOB sources "${SOURCE_DIR}/Filters/Numerics/*.h" "${SOURCE_DIR}/Filters/Numerics/*.cxx"
  "${SOURCE_DIR}/IO/Parsers/*.h" "${SOURCE_DIR}/IO/Parsers/*.cxx")
if (NOT sources)
  message(FATAL_ERROR "No sources of the core found below ${SOURCE_DIR}")
endif ()
foreach (source IN LISTS sources)
  file(STRINGS "${source}" includes REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]vtk")
  foreach (include IN LISTS includes)
    message(SEND_ERROR "${source}: ${include}")
  endforeach ()
endforeach ()
