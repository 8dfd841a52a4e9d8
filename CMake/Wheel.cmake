# What differs in the wheel: `pip install .` configures by scikit-build-core, which sets SKBUILD. The
# wheel contains the package and its libraries in one folder, beside that of the wheel vtk, whose
# libraries it shares. Everything else comes from that wheel, so that users install nothing else.
include_guard(GLOBAL)

# Below site-packages, the prefix of scikit-build-core.
set(CONFORMALSOM_PYTHON_DESTINATION ".")
set(CMAKE_INSTALL_LIBDIR "conformalsom")
set(CMAKE_INSTALL_BINDIR "conformalsom") # of Windows' libraries
if (APPLE)
  set(CMAKE_INSTALL_RPATH "@loader_path" "@loader_path/../vtkmodules")
elseif (NOT WIN32)
  set(CMAKE_INSTALL_RPATH "$ORIGIN" "$ORIGIN/../vtkmodules")
endif ()

# The package cmeel-eigen has Eigen's headers in a folder of its own.
execute_process(
  COMMAND "${Python3_EXECUTABLE}" -c
    "import os, sys; print(*(p + '/cmeel.prefix' for p in sys.path if os.path.isdir(p + '/cmeel.prefix')), sep=';')"
  OUTPUT_VARIABLE eigen_prefix OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(TO_CMAKE_PATH "${eigen_prefix}" eigen_prefix)
list(APPEND CMAKE_PREFIX_PATH ${eigen_prefix})

# conformal_use_vtk_library(<module> <target> <header>): let <target> be VTK's own copy of a library,
# and <header> be its header.
function (conformal_use_vtk_library module target header)
  set(folder "${PROJECT_BINARY_DIR}/CMakeFiles/ForwardingHeaders")
  file(WRITE "${folder}/${header}" "#include <vtk_${header}>\n")
  add_library(${target} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${target} INTERFACE "${folder}")
  target_link_libraries(${target} INTERFACE ${module})
endfunction ()

# conformal_use_vtk_abi(<target>): compile what links to <target> with the C++ ABI of VTK's libraries.
# Wheels for old systems have the one that libstdc++ had before GCC 5.
function (conformal_use_vtk_abi target)
  include(CheckCXXSourceCompiles)
  set(CMAKE_REQUIRED_LIBRARIES VTK::CommonCore)
  set(program "
    #include <vtkObject.h>
    int main() { return vtkObject::New()->vtkObjectBase::GetObjectDescription().empty(); }")
  check_cxx_source_compiles("${program}" CONFORMALSOM_ABI_IS_DEFAULT)
  if (CONFORMALSOM_ABI_IS_DEFAULT)
    return ()
  endif ()
  set(CMAKE_REQUIRED_DEFINITIONS -D_GLIBCXX_USE_CXX11_ABI=0)
  check_cxx_source_compiles("${program}" CONFORMALSOM_ABI_IS_OLD)
  if (NOT CONFORMALSOM_ABI_IS_OLD)
    message(FATAL_ERROR "A program cannot be linked to VTK's libraries; see CMakeError.log")
  endif ()
  target_compile_definitions(${target} INTERFACE _GLIBCXX_USE_CXX11_ABI=0)
endfunction ()

# three.js is compiled into the writer of pages; the repository does not contain it. This version is the
# last whose minified classic script does not print that later versions have none.
set(CONFORMALSOM_THREE_JS "" CACHE FILEPATH
  "Build of three.js, such as three.min.js, to compile into the writer of pages; from npm if empty")
if (NOT CONFORMALSOM_THREE_JS)
  set(archive "${PROJECT_BINARY_DIR}/three.tgz")
  file(DOWNLOAD "https://registry.npmjs.org/three/-/three-0.149.0.tgz" "${archive}" STATUS status
    EXPECTED_HASH SHA256=ab8b7c131f6ce72e05081dff4882046584e4a4ce5ad864f9f2a0e3146cc3997c)
  list(GET status 0 code)
  if (NOT code EQUAL 0)
    list(GET status 1 reason)
    message(FATAL_ERROR "three.js could not be downloaded (${reason}). "
      "Name a file of it: pip install . --config-settings=cmake.define.CONFORMALSOM_THREE_JS=FILE")
  endif ()
  file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${PROJECT_BINARY_DIR}/three"
    PATTERNS package/build/three.min.js package/LICENSE)
  set(CONFORMALSOM_THREE_JS "${PROJECT_BINARY_DIR}/three/package/build/three.min.js")
endif ()
