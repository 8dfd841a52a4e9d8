# Debian's packages have compressed manual pages; other systems compress what is installed by themselves.
file(GLOB_RECURSE pages "${CPACK_TEMPORARY_DIRECTORY}/conformalsom*.1")
foreach (page IN LISTS pages)
  execute_process(COMMAND gzip --best --no-name --force "${page}" COMMAND_ERROR_IS_FATAL ANY)
endforeach ()
