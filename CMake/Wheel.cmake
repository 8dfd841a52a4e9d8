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

# conformal_fetch(<name> <url> <sha256> <variable> <pattern>...): unpack files of an archive into the folder <name> of
# the build. If the archive cannot be downloaded, users can set <variable> instead.
function (conformal_fetch name url hash variable)
  set(archive "${PROJECT_BINARY_DIR}/${name}.tar.gz")
  file(DOWNLOAD "${url}" "${archive}" STATUS status EXPECTED_HASH SHA256=${hash})
  list(GET status 0 code)
  if (NOT code EQUAL 0)
    list(GET status 1 reason)
    message(FATAL_ERROR "${name} could not be downloaded (${reason}). Unpack it from ${url}, and run "
      "pip install . --config-settings=cmake.define.${variable}=PATH")
  endif ()
  file(ARCHIVE_EXTRACT INPUT "${archive}" DESTINATION "${PROJECT_BINARY_DIR}/${name}" PATTERNS ${ARGN})
endfunction ()

# three.js is compiled into the writer of pages; the repository does not contain it. This version is the
# last whose minified classic script does not print that later versions have none.
set(CONFORMALSOM_THREE_JS "" CACHE FILEPATH
  "Build of three.js, such as three.min.js, to compile into the writer of pages; from npm if empty")
if (NOT CONFORMALSOM_THREE_JS)
  conformal_fetch(three.js https://registry.npmjs.org/three/-/three-0.149.0.tgz
    ab8b7c131f6ce72e05081dff4882046584e4a4ce5ad864f9f2a0e3146cc3997c
    CONFORMALSOM_THREE_JS package/build/three.min.js package/LICENSE)
  set(CONFORMALSOM_THREE_JS "${PROJECT_BINARY_DIR}/three.js/package/build/three.min.js")
endif ()

# meshoptimizer compresses glTF files. Its source is that of the package of PyPI. A shared library of the system would
# be missing on other systems.
set(CONFORMALSOM_MESHOPTIMIZER "" CACHE PATH
  "Folder of the C++ sources of meshoptimizer, which compresses glTF files; from PyPI if empty")
if (NOT CONFORMALSOM_MESHOPTIMIZER)
  set(release meshoptimizer-0.2.30a0) # contains version 0.22 of the library
  conformal_fetch(meshoptimizer
    https://files.pythonhosted.org/packages/35/b9/23259780df3097b6b70e7091970a689b677bd320b02a63fdf60493902167/${release}.tar.gz
    36b18b61a95ba992de804b1e91e86be2ba185925e4e2c1481495f8c68a17f5db
    CONFORMALSOM_MESHOPTIMIZER "${release}/src/*")
  set(CONFORMALSOM_MESHOPTIMIZER "${PROJECT_BINARY_DIR}/meshoptimizer/${release}/src")
endif ()

# conformal_add_meshoptimizer(): the target that a system's package has, with the sources that the writer uses
function (conformal_add_meshoptimizer)
  set(units allocator indexcodec indexgenerator vcacheoptimizer vertexcodec vertexfilter vfetchoptimizer)
  list(TRANSFORM units REPLACE "(.+)" "${CONFORMALSOM_MESHOPTIMIZER}/\\1.cpp")
  add_library(meshoptimizer STATIC ${units})
  add_library(meshoptimizer::meshoptimizer ALIAS meshoptimizer)
  target_include_directories(meshoptimizer PUBLIC "$<BUILD_INTERFACE:${CONFORMALSOM_MESHOPTIMIZER}>")
  target_link_libraries(meshoptimizer PRIVATE conformalBuild)
  set_target_properties(meshoptimizer PROPERTIES UNITY_BUILD OFF)
endfunction ()

# Both licenses require their text beside the compiled code. That of meshoptimizer is the last comment of its header.
file(READ "${CONFORMALSOM_MESHOPTIMIZER}/meshoptimizer.h" header)
string(FIND "${header}" "/**" start REVERSE)
string(SUBSTRING "${header}" ${start} -1 license)
file(WRITE "${PROJECT_BINARY_DIR}/licenses/meshoptimizer.txt" "${license}")
if (EXISTS "${PROJECT_BINARY_DIR}/three.js/package/LICENSE")
  configure_file("${PROJECT_BINARY_DIR}/three.js/package/LICENSE" "${PROJECT_BINARY_DIR}/licenses/three.js.txt" COPYONLY)
endif ()
install(DIRECTORY "${PROJECT_BINARY_DIR}/licenses" DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT runtime)
