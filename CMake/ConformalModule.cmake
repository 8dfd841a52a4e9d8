# conformal_add_module(<module> [LIBRARIES <library>...])
#
# The VTK module ConformalSOM::<module> of this folder: each header is a class of its name. It is
# linked privately with the core, the glue and the given libraries.
function (conformal_add_module module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LIBRARIES")
  file(GLOB classes RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "vtk*.h")
  list(TRANSFORM classes REPLACE "\\.h$" "")
  conformal_keep_reachable(classes)
  vtk_module_add_module(ConformalSOM::${module} CLASSES ${classes})
  set(libraries conformalGlue conformalNumerics ${arg_LIBRARIES} conformalWarnings)
  list(TRANSFORM libraries REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")
  vtk_module_link(ConformalSOM::${module} PRIVATE ${libraries})
endfunction ()

# conformal_find_left_out(<result>): the classes that are not built, since their module is not one of
# `modules`, or since no class of CONFORMALSOM_CLASSES needs them.
function (conformal_find_left_out result)
  set(left_out)
  foreach (folder IN LISTS module_folders)
    string(REGEX REPLACE ".*/([^/]+)/([^/]+)$" "ConformalSOM::\\1\\2" module "${folder}")
    file(GLOB headers "${folder}/vtk*.h")
    foreach (header IN LISTS headers)
      string(REGEX REPLACE "\\.h$" "" unit "${header}")
      if (NOT module IN_LIST modules OR (reachable_units AND NOT unit IN_LIST reachable_units))
        get_filename_component(class "${header}" NAME_WE)
        list(APPEND left_out "${class}")
      endif ()
    endforeach ()
  endforeach ()
  set(${result} "${left_out}" PARENT_SCOPE)
endfunction ()
