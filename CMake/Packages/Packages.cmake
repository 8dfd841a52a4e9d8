# Packages of Debian by CPack: libconformalsom, -dev, python3-conformalsom, paraview-conformalsom, and
# the archive of the sources. The plugin comes from a build of its own, against ParaView's VTK;
# CMake/make-packages.sh makes both builds, and all packages out of the second. What is said of the packages
# is taken from debian/control.in, of which CMake/make-source-package.sh makes the source package.
set(packages_dir "${CMAKE_CURRENT_LIST_DIR}/debian")

# debian_field(<component> <package> <field> [<more>...]): sets CPack's field of a component to that of the package
# in control.in, without what debhelper would replace, and with more before it
function (debian_field component package field)
  file(READ "${packages_dir}/control.in" control)
  string(REPLACE "${version_suffix}" "@version_suffix@" package "${package}")
  string(FIND "${control}" "\nPackage: ${package}\n" begin)
  if (begin EQUAL -1)
    message(FATAL_ERROR "control.in has no package ${package}")
  endif ()
  string(SUBSTRING "${control}" ${begin} -1 control)
  string(REGEX REPLACE "\n\n.*" "" control "${control}\n\n")
  string(REGEX MATCH "\n${field}: *([^\n]*(\n [^\n]*)*)" found "${control}\n")
  set(value "${CMAKE_MATCH_1}")
  string(TOUPPER "${field}" name)
  if (field STREQUAL "Description") # its first line is that of all packages
    string(FIND "${value}" "\n " begin)
    string(SUBSTRING "${value}" ${begin} -1 value)
    string(REGEX REPLACE "^\n " "" value "${value}")
    string(REPLACE "\n " "\n" value "${value}")
    set(CPACK_COMPONENT_${component}_DESCRIPTION "${value}" PARENT_SCOPE)
    return ()
  endif ()
  string(REGEX REPLACE "[ \n]*,[ \n]*" ";" value "${value}")
  list(FILTER value EXCLUDE REGEX "[$]{|@version_suffix@|conformalsom|^[ \n]*$")
  list(TRANSFORM value STRIP)
  set(value ${ARGN} ${value})
  list(JOIN value ", " value)
  set(CPACK_DEBIAN_${component}_PACKAGE_${name} "${value}" PARENT_SCOPE)
endfunction ()

# debian_documents(<component> <package>): what the policy wants below /usr/share/doc
function (debian_documents component package)
  install(FILES "${packages_dir}/copyright" "${PROJECT_BINARY_DIR}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT ${component})
  string(REPLACE "${version_suffix}" "" unversioned "${package}")
  if (EXISTS "${packages_dir}/${unversioned}.lintian-overrides")
    install(FILES "${packages_dir}/${unversioned}.lintian-overrides"
      DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides"
      RENAME "${package}"
      COMPONENT ${component})
  endif ()
endfunction ()

find_program(CONFORMALSOM_GZIP gzip)
if (NOT CONFORMALSOM_GZIP)
  return () # not a system that packages are made on
endif ()
configure_file("${packages_dir}/changelog.in" "${PROJECT_BINARY_DIR}/changelog.Debian" @ONLY)
execute_process(
  COMMAND "${CONFORMALSOM_GZIP}" --best --no-name --stdout changelog.Debian
  WORKING_DIRECTORY "${PROJECT_BINARY_DIR}"
  OUTPUT_FILE "${PROJECT_BINARY_DIR}/changelog.Debian.gz")

## The plugin's part ---------------------------------------------------------------
if (CONFORMALSOM_PARAVIEW_PLUGIN)
  debian_documents(plugin paraview-conformalsom)
  # Where ParaView looks for plugins of others: Debian's 5.11 reads a list of such lists beside its
  # programs, newer ones come with that, and it names a list below /usr/share that is for others.
  set(plugins "${CMAKE_INSTALL_FULL_LIBDIR}/${PARAVIEW_PLUGIN_SUBDIR}")
  if (ParaView_VERSION VERSION_LESS 5.12)
    file(WRITE "${PROJECT_BINARY_DIR}/paraview.conf" "${plugins}/conformalsom.plugins.xml\n")
    install(FILES "${PROJECT_BINARY_DIR}/paraview.conf"
      DESTINATION "${CMAKE_INSTALL_BINDIR}"
      COMPONENT plugin)
  else ()
    file(WRITE "${PROJECT_BINARY_DIR}/plugins.xml" "<?xml version=\"1.0\"?>\n<Plugins>\n"
      "  <Plugin name=\"ConformalSOM\" auto_load=\"1\" filename=\"${plugins}/ConformalSOM/ConformalSOM.so\"/>\n"
      "</Plugins>\n")
    install(FILES "${PROJECT_BINARY_DIR}/plugins.xml"
      DESTINATION "${CMAKE_INSTALL_DATADIR}/paraview"
      RENAME plugins
      COMPONENT plugin)
  endif ()
  return ()
endif ()

## All packages ----------------------------------------------------------------------
set(library_package "libconformalsom${version_suffix}")
debian_documents(runtime "${library_package}")
debian_documents(development libconformalsom-dev)
debian_documents(python python3-conformalsom)

set(CPACK_PACKAGE_NAME conformalsom)
set(CPACK_PACKAGE_CONTACT "${CONFORMALSOM_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "closed smooth surfaces with a one-to-one map to the sphere")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_CURRENT_LIST_DIR}/CompressManual.cmake")
set(CPACK_GENERATOR DEB)

set(CPACK_COMPONENTS_ALL runtime development python)
set(CPACK_INSTALL_CMAKE_PROJECTS "${PROJECT_BINARY_DIR};${PROJECT_NAME};ALL;/")
set(private_folders "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(plugin_build "${PROJECT_BINARY_DIR}-paraview")
if (EXISTS "${plugin_build}/cmake_install.cmake")
  list(APPEND CPACK_COMPONENTS_ALL plugin)
  set(CPACK_COMPONENTS_PLUGIN plugin) # of what the second build installs, this
  list(APPEND CPACK_INSTALL_CMAKE_PROJECTS "${plugin_build};${PROJECT_NAME};plugin;/")
endif ()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SOURCE conformalsom)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${private_folders}")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS ON)

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "${library_package}")
debian_field(RUNTIME "${library_package}" Section)
set(shlibs)
foreach (module IN LISTS modules)
  string(REPLACE "ConformalSOM::" "libvtk" library "${module}")
  string(APPEND shlibs
    "${library}-${version_suffix} ${version_suffix} ${library_package} (>= ${PROJECT_VERSION})\n")
endforeach ()
file(WRITE "${PROJECT_BINARY_DIR}/shlibs" "${shlibs}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/shlibs" "${CMAKE_CURRENT_LIST_DIR}/triggers")
debian_field(RUNTIME "${library_package}" Description)

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libconformalsom-dev)
debian_field(DEVELOPMENT libconformalsom-dev Section)
debian_field(DEVELOPMENT libconformalsom-dev Depends)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime python) # the exported targets name both
debian_field(DEVELOPMENT libconformalsom-dev Description)

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-conformalsom)
debian_field(PYTHON python3-conformalsom Section)
if (CONFORMALSOM_WRAP_PYTHON)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  debian_field(PYTHON python3-conformalsom Depends
    "python3 (>= 3.${Python3_VERSION_MINOR})" "python3 (<< 3.${next_minor})")
endif ()
debian_field(PYTHON python3-conformalsom Recommends) # for pages and maps
debian_field(PYTHON python3-conformalsom Suggests) # for conformalsom.pyvista
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
debian_field(PYTHON python3-conformalsom Description)

set(CPACK_DEBIAN_PLUGIN_PACKAGE_NAME paraview-conformalsom)
set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS paraview)
debian_field(PLUGIN paraview-conformalsom Description)

## The archive of the sources ----------------------------------------------------------
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "conformalsom-${PROJECT_VERSION}")
set(CPACK_SOURCE_IGNORE_FILES "^${PROJECT_SOURCE_DIR}/build/" "/[.]git/" "/[.]git$" "/__pycache__/")

include(CPack)
