# Packages of Debian by CPack: libconformalsom, -dev, python3-conformalsom, paraview-conformalsom, and
# the archive of the sources. The plugin comes from a build of its own, against ParaView's VTK;
# CMake/make-packages.sh makes both builds, and all packages out of the second.
set(packages_dir "${CMAKE_CURRENT_LIST_DIR}")

# debian_documents(<component> <package>): what the policy wants below /usr/share/doc
function (debian_documents component package)
  install(FILES "${packages_dir}/copyright" "${PROJECT_BINARY_DIR}/changelog.Debian.gz"
    DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}"
    COMPONENT ${component})
  if (EXISTS "${packages_dir}/${package}.lintian-overrides")
    install(FILES "${packages_dir}/${package}.lintian-overrides"
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
execute_process(
  COMMAND "${CONFORMALSOM_GZIP}" --best --no-name --stdout conformalsom.1
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}/Wrapping/Python"
  OUTPUT_FILE "${PROJECT_BINARY_DIR}/conformalsom.1.gz")
install(FILES "${PROJECT_BINARY_DIR}/conformalsom.1.gz"
  DESTINATION "${CMAKE_INSTALL_MANDIR}/man1"
  COMPONENT python)

set(CPACK_PACKAGE_NAME conformalsom)
set(CPACK_PACKAGE_CONTACT "${CONFORMALSOM_MAINTAINER}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "closed smooth surfaces with a one-to-one map to the sphere")
set(CPACK_PACKAGE_DIRECTORY "${PROJECT_BINARY_DIR}/packages")
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_STRIP_FILES ON)
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

set(about "ConformalSOM learns a closed, smooth surface with a one-to-one map to the
sphere from the points of a scan, by conformal self-organizing maps, so that
pictures and measurements can be carried over between surfaces.")

set(CPACK_DEBIAN_RUNTIME_PACKAGE_NAME "${library_package}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_SECTION libs)
set(shlibs)
foreach (module IN LISTS modules)
  string(REPLACE "ConformalSOM::" "libvtk" library "${module}")
  string(APPEND shlibs
    "${library}-${version_suffix} ${version_suffix} ${library_package} (>= ${PROJECT_VERSION})\n")
endforeach ()
file(WRITE "${PROJECT_BINARY_DIR}/shlibs" "${shlibs}")
set(CPACK_DEBIAN_RUNTIME_PACKAGE_CONTROL_EXTRA "${PROJECT_BINARY_DIR}/shlibs" "${packages_dir}/triggers")
set(CPACK_COMPONENT_RUNTIME_DESCRIPTION
  "${about}\n.\nThis package has the filters, readers and writers as libraries for VTK.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libconformalsom-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS libvtk9-dev)
set(CPACK_COMPONENT_DEVELOPMENT_DEPENDS runtime python) # the exported targets name both
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
  "${about}\n.\nThis package has the headers, and the files by which CMake finds the\nlibraries.")

set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-conformalsom)
set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
if (CONFORMALSOM_WRAP_PYTHON)
  math(EXPR next_minor "${Python3_VERSION_MINOR} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "python3 (>= 3.${Python3_VERSION_MINOR}), python3 (<< 3.${next_minor}), python3-vtk9, python3-numpy")
endif ()
set(CPACK_DEBIAN_PYTHON_PACKAGE_RECOMMENDS "libjs-three, python3-gdal") # for pages and maps
set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS python3-pyvista) # for conformalsom.pyvista
set(CPACK_COMPONENT_PYTHON_DEPENDS runtime)
set(CPACK_COMPONENT_PYTHON_DESCRIPTION
  "${about}\n.\nThis package has the Python package conformalsom, for use with vtkmodules.")

set(CPACK_DEBIAN_PLUGIN_PACKAGE_NAME paraview-conformalsom)
set(CPACK_DEBIAN_PLUGIN_PACKAGE_DEPENDS paraview)
set(CPACK_COMPONENT_PLUGIN_DESCRIPTION
  "${about}\n.\nThis package has the filters, readers and writers as a plugin that\nParaView, pvserver and pvbatch load when they start.")

## The archive of the sources ----------------------------------------------------------
set(CPACK_SOURCE_GENERATOR TGZ)
set(CPACK_SOURCE_PACKAGE_FILE_NAME "conformalsom-${PROJECT_VERSION}")
set(CPACK_SOURCE_IGNORE_FILES "^${PROJECT_SOURCE_DIR}/build/" "/[.]git/" "/[.]git$" "/__pycache__/")

include(CPack)
