# Every class of a module has all that CONTRIBUTING.md asks for; what is missing is named.
cmake_minimum_required(VERSION 3.18)

function (require_file class path)
  if (NOT EXISTS "${SOURCE_DIR}/${path}")
    message(SEND_ERROR "${class}: ${path} is missing")
  endif ()
endfunction ()

function (require_line class path pattern what)
  file(STRINGS "${SOURCE_DIR}/${path}" lines REGEX "${pattern}")
  if (NOT lines)
    message(SEND_ERROR "${class}: ${path} lacks ${what}")
  endif ()
endfunction ()

# The glue includes a header of its layer's core, so the work is done where no VTK is.
function (require_core class glue core_folder)
  file(STRINGS "${SOURCE_DIR}/${glue}" includes REGEX "^#include \"[A-Z]")
  foreach (include IN LISTS includes)
    string(REGEX REPLACE "^#include \"(.*)\".*" "\\1" header "${include}")
    if (EXISTS "${SOURCE_DIR}/${core_folder}/${header}")
      return()
    endif ()
  endforeach ()
  message(SEND_ERROR "${class}: ${glue} includes no header of ${core_folder}")
endfunction ()

# Whether a class makes objects; a base that nobody can make or derive from is not shown to users.
function (is_concrete class header result)
  file(READ "${SOURCE_DIR}/${header}" text)
  if (text MATCHES "static ${class}\\* New\\(\\)")
    set(${result} TRUE PARENT_SCOPE)
  else ()
    set(${result} FALSE PARENT_SCOPE)
  endif ()
endfunction ()

# A class that makes objects for a pipeline and has inputs gets broken ones in a test. Tables have no
# points and cells that could be broken.
function (require_input_case class header)
  file(READ "${SOURCE_DIR}/${header}" text)
  if (text MATCHES "static ${class}\\* New\\(\\)" AND NOT text MATCHES "${class} : public vtkObject\n"
      AND NOT text MATCHES "Input port 0: vtkTable" AND NOT class MATCHES "(Reader|Source)$")
    require_line(${class} Testing/Cxx/InputCases.h "\"${class}\"" "a case \"${class}\"")
  endif ()
endfunction ()

# A filter that makes objects for a pipeline has its progress measured.
function (require_measured_progress class header)
  file(READ "${SOURCE_DIR}/${header}" text)
  if (text MATCHES "static ${class}\\* New\\(\\)" AND NOT text MATCHES "${class} : public vtkObject\n"
      AND NOT class MATCHES "(Reader|Writer)$")
    require_line(${class} Testing/Cxx/TestProgress.cxx "[<= ]${class}[>;]" "a run of ${class}")
  endif ()
endfunction ()

# A class that hands properties to the core has the core's defaults and enumerations, by a test.
function (require_mirrored_options class glue)
  file(READ "${SOURCE_DIR}/${glue}" text)
  if (text MATCHES "conformal::[A-Za-z]+Options options;")
    require_line(${class} Testing/Glue/TestOptionsMirrorProperties.cxx "vtkNew<${class}>"
      "a comparison of ${class} with its options")
  endif ()
endfunction ()

function (check_module folder core_folder document)
  file(GLOB headers "${SOURCE_DIR}/${folder}/vtk*.h")
  foreach (header IN LISTS headers)
    get_filename_component(class "${header}" NAME_WE)
    file(STRINGS "${header}" exported REGEX "^class VTK[A-Z]+_EXPORT ${class} ")
    if (NOT exported)
      continue ()
    endif ()
    string(REGEX REPLACE "^vtk" "" unit "${class}")
    string(REGEX REPLACE "([a-z0-9])([A-Z])" "\\1 \\2" words "${unit}")
    string(REGEX REPLACE "([A-Z])([A-Z][a-z])" "\\1 \\2" words "${words}")
    require_file(${class} "Testing/Cxx/Test${unit}.cxx")
    is_concrete(${class} "${folder}/${class}.h" concrete)
    if (concrete)
      require_line(${class} "${document}" "^##+ ${words}$" "a section \"${words}\"")
      require_line(${class} README.md "${class}" "the class")
    endif ()
    require_core(${class} "${folder}/${class}.cxx" "${core_folder}")
    require_input_case(${class} "${folder}/${class}.h")
    require_mirrored_options(${class} "${folder}/${class}.cxx")
    require_measured_progress(${class} "${folder}/${class}.h")
  endforeach ()
endfunction ()

foreach (module IN ITEMS Conformal Correspondence Shape)
  check_module(Filters/${module} Filters/Numerics Documentation/Filters.md)
endforeach ()
check_module(IO/Surface IO/Formats Documentation/Readers.md)
