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
