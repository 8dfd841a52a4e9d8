# conformal_add_module(<module> [PRIVATE <unit>...] [LIBRARIES <library>...])
#
# The VTK module ConformalSOM::<module> of this folder: each header is a class of its name, but for
# the private units. It is linked privately with the core, the glue and the given libraries.
function (conformal_add_module module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PRIVATE;LIBRARIES")
  file(GLOB classes RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" CONFIGURE_DEPENDS "vtk*.h")
  list(TRANSFORM classes REPLACE "\\.h$" "")
  if (arg_PRIVATE)
    list(REMOVE_ITEM classes ${arg_PRIVATE})
  endif ()
  conformal_keep_reachable(classes)
  set(sources ${arg_PRIVATE})
  conformal_keep_reachable(sources)
  set(private_headers ${sources})
  list(TRANSFORM sources APPEND ".cxx")
  list(TRANSFORM private_headers APPEND ".h")
  vtk_module_add_module(ConformalSOM::${module}
    CLASSES         ${classes}
    SOURCES         ${sources}
    PRIVATE_HEADERS ${private_headers})
  set(libraries conformalGlue conformalNumerics ${arg_LIBRARIES} conformalWarnings)
  list(TRANSFORM libraries REPLACE "(.+)" "$<BUILD_INTERFACE:\\1>")
  vtk_module_link(ConformalSOM::${module} PRIVATE ${libraries})
endfunction ()
