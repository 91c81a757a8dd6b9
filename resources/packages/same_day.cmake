# Run by cpack on the tree to be packed: one day and plain permissions for everything, whoever builds and when.
if(DEFINED ENV{SOURCE_DATE_EPOCH})
    file(GLOB_RECURSE packed LIST_DIRECTORIES TRUE ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/*)
    foreach(path IN LISTS packed)
        execute_process(COMMAND touch --no-dereference --date=@$ENV{SOURCE_DATE_EPOCH} ${path} COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
endif()
