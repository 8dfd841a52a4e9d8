# A room of IO/Formats holds one file format and includes itself, Bytes, what the table allows, and of
# the core its execution context; no two units (a header and its source) include each other, not even through others.
cmake_minimum_required(VERSION 3.18)

file(GLOB rooms RELATIVE "${SOURCE_DIR}/IO/Formats" "${SOURCE_DIR}/IO/Formats/*")
set(below_others Bytes Text Coordinates PLY)
list(REMOVE_ITEM rooms CMakeLists.txt ${below_others})
list(PREPEND rooms ${below_others})
set(below_Bytes)
foreach (room IN LISTS rooms)
  if (NOT room STREQUAL "Bytes")
    set(below_${room} Bytes)
  endif ()
endforeach ()
foreach (room IN ITEMS E57 LAS)
  list(APPEND below_${room} Coordinates) # the shift of map coordinates
endforeach ()
list(APPEND below_StanfordScans PLY) # the scans are PLY files
foreach (room IN ITEMS E57 GIFTI Page Textured)
  list(APPEND below_${room} Text) # base64, JSON, XML
endforeach ()

# All may include the execution context of the core.
set(lent_headers Base/Run.h)

include("${CMAKE_CURRENT_LIST_DIR}/IncludeDownward.cmake")
check_rooms("${SOURCE_DIR}/IO/Formats")
