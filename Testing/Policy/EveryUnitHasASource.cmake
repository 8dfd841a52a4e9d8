# Every header of the core cites the source of its method, or states that the method is an own
# construction. Every cited key has an entry in Documentation/references.bib.
cmake_minimum_required(VERSION 3.18)

# Types and helpers without a method: no source needed.
set(exempt
  Base/AcrossProcesses.h
  Base/KeptIds.h
  Base/Lanes.h
  Base/NumericalFailure.h
  Base/Random.h
  Base/Reduce.h
  Base/Run.h
  Base/Steps.h
  Base/Types.h
  Base/UnitBox.h
  Learn/Fit/FitOptions.h
  Learn/Fit/LearnedMesh.h
  Mesh/Mesh.h
  Mesh/MeshTopology.h
  Mesh/SurfacePlace.h
  Mesh/VertexRings.h
  Texture/PixelGrid.h)

set(core "${SOURCE_DIR}/Filters/Numerics")
file(GLOB_RECURSE headers RELATIVE "${core}" "${core}/*.h")
list(LENGTH headers number)
if (number LESS 100)
  message(FATAL_ERROR "Only ${number} headers were found to check")
endif ()
foreach (header IN LISTS exempt)
  if (NOT header IN_LIST headers)
    message(SEND_ERROR "${header} needs no source by the list of this policy, but does not exist")
  endif ()
endforeach ()

file(READ "${SOURCE_DIR}/Documentation/references.bib" references)
string(REGEX MATCHALL "@[a-z]+{[A-Za-z0-9]+," keys "${references}")
list(TRANSFORM keys REPLACE "@[a-z]+{([A-Za-z0-9]+)," "\\1")

foreach (header IN LISTS headers)
  file(READ "${core}/${header}" text)
  if (text MATCHES "[\\]cite *(\n|[A-Za-z0-9]+:)")
    message(SEND_ERROR "Filters/Numerics/${header}: Doxygen finds no citation where a line ends with \\cite, "
      "or where a colon follows the key")
  endif ()
  string(REGEX REPLACE "\n *//+<?" " " text "${text}")
  string(REGEX MATCHALL "[\\]cite +[A-Za-z0-9]+" citations "${text}")
  foreach (citation IN LISTS citations)
    string(REGEX REPLACE "[\\]cite +" "" key "${citation}")
    if (NOT key IN_LIST keys)
      message(SEND_ERROR "Filters/Numerics/${header} cites ${key}, which is not in Documentation/references.bib")
    endif ()
  endforeach ()
  if (NOT citations AND NOT text MATCHES "[Oo]wn +construction" AND NOT header IN_LIST exempt)
    message(SEND_ERROR "Filters/Numerics/${header} neither cites a source (\\cite Key) nor states \"own construction\"")
  endif ()
endforeach ()
