# Every property of every filter, source and writer has cases "CLASS (MODE)/PROPERTY VALUE" of its
# own; those that have none are named. Readers have fuzzers instead. Writers of tables and images have
# no cases, see Testing/Policy/EveryFilterIsComplete.cmake.
cmake_minimum_required(VERSION 3.18)

# Connections and data are inputs, which all cases are about; objects have no extreme values.
set(no_property "(Connection|Data|Controller|To[A-Z][A-Za-z]*)$")

execute_process(COMMAND "${HOSTILE}" --list OUTPUT_VARIABLE cases RESULT_VARIABLE failed)
if (failed)
  message(FATAL_ERROR "${HOSTILE} --list failed: ${failed}")
endif ()

set(tried 0)
file(GLOB headers "${SOURCE_DIR}/Filters/*/vtk*.h" "${SOURCE_DIR}/IO/*/vtk*.h")
foreach (header IN LISTS headers)
  get_filename_component(class "${header}" NAME_WE)
  file(READ "${header}" text)
  if (class MATCHES "Reader$" OR NOT text MATCHES "static ${class}\\* New\\(\\)"
      OR (class MATCHES "Writer$" AND text MATCHES "put port 0: vtk(Table|ImageData)"))
    continue ()
  endif ()
  string(REGEX MATCHALL "(vtkSet[A-Za-z0-9]*Macro\\(|void Set)[A-Za-z0-9]+" setters "${text}")
  foreach (setter IN LISTS setters)
    string(REGEX REPLACE "^(vtkSet[A-Za-z0-9]*Macro\\(|void Set)" "" property "${setter}")
    if (property MATCHES "${no_property}")
      continue ()
    endif ()
    math(EXPR tried "${tried} + 1")
    if (NOT "\n${cases}" MATCHES "\n${class}( \\([^\n]*\\))?/${property} ")
      message(SEND_ERROR "${class}: no mode in Testing/Cases sets ${property}")
    endif ()
  endforeach ()
endforeach ()
if (tried EQUAL 0)
  message(FATAL_ERROR "no header has properties: they are not found as they are declared")
endif ()
message(STATUS "${tried} properties")
