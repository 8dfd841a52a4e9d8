# conformal_unite_folders(<target>)
#
# Where CMAKE_UNITY_BUILD is on, the sources of each folder are compiled as one file: two folders may
# have helpers of one name, the files of one folder may not.
function (conformal_unite_folders target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach (source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    set_source_files_properties("${source}" PROPERTIES UNITY_GROUP "${folder}")
  endforeach ()
endfunction ()
