# A build of chosen classes has what these need and nothing else, and a class that there is not is an error.
cmake_minimum_required(VERSION 3.18)

set(build "${WORK_DIR}/chosen")
file(REMOVE_RECURSE "${build}")
set(configure "${CMAKE_COMMAND}" -S "${SOURCE_DIR}" -B "${build}" -G "${GENERATOR}"
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON -DCONFORMALSOM_WRAP_PYTHON=OFF
  -DCMAKE_SHARED_LINKER_FLAGS=-Wl,--no-undefined)

execute_process(COMMAND ${configure} -DCONFORMALSOM_CLASSES=vtkNoFilter
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (result EQUAL 0 OR NOT output MATCHES "there is no class vtkNoFilter")
  message(FATAL_ERROR "vtkNoFilter was accepted, or not named: ${output}")
endif ()

execute_process(COMMAND ${configure} -DCONFORMALSOM_CLASSES=vtkGeodesicSphere*\\;vtkConformalOFF*
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif ()
execute_process(COMMAND "${CMAKE_COMMAND}" --build "${build}" --target FiltersConformal IOSurface
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if (NOT result EQUAL 0)
  message(FATAL_ERROR "${output}")
endif ()
file(READ "${build}/compile_commands.json" commands)
foreach (unit IN ITEMS vtkGeodesicSphereSource Mesh/GeodesicSphere vtkConformalOFFReader vtkConformalOFFWriter OFF/OFFParser)
  if (NOT commands MATCHES "/${unit}\\.cxx\"")
    message(SEND_ERROR "The build lacks ${unit}")
  endif ()
endforeach ()
foreach (unit IN ITEMS vtkConformalSOM Learn/ConformalSOM Register/SphericalRegistration vtkConformalPLYReader
    PLY/PLYParser)
  if (commands MATCHES "/${unit}\\.cxx\"")
    message(SEND_ERROR "The build has ${unit}, which the classes do not need")
  endif ()
endforeach ()
file(REMOVE_RECURSE "${build}")
