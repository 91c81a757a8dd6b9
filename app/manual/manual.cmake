# Man pages and completions are made at every build from the parser itself, by a program that is not installed.
find_program(GZIP gzip REQUIRED)
add_executable(copperscope_manual manual_main.cpp)
target_link_libraries(copperscope_manual PRIVATE copperscope_app)
target_compile_definitions(copperscope_manual PRIVATE COPPERSCOPE_VERSION="${PROJECT_VERSION}")

set(COPPERSCOPE_MANUAL ${PROJECT_BINARY_DIR}/manual)
set(COPPERSCOPE_MANUAL ${COPPERSCOPE_MANUAL} PARENT_SCOPE)  # for the tests
add_custom_command(OUTPUT ${COPPERSCOPE_MANUAL}/copperscope.bash
    COMMAND ${CMAKE_COMMAND} -E rm -rf ${COPPERSCOPE_MANUAL}
    COMMAND copperscope_manual ${COPPERSCOPE_MANUAL}
    COMMAND sh -c "\"$0\" -9nk \"$1\"/*.1" ${GZIP} ${COPPERSCOPE_MANUAL}
    DEPENDS copperscope_manual VERBATIM)
add_custom_target(manual ALL DEPENDS ${COPPERSCOPE_MANUAL}/copperscope.bash)

include(GNUInstallDirs)
set(COPPERSCOPE_ZSH_COMPLETIONS ${CMAKE_INSTALL_DATADIR}/zsh/site-functions CACHE STRING "Where zsh looks for completions")
install(DIRECTORY ${COPPERSCOPE_MANUAL}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN *.1.gz)
install(FILES ${COPPERSCOPE_MANUAL}/copperscope.bash DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME copperscope)
install(FILES ${COPPERSCOPE_MANUAL}/_copperscope DESTINATION ${COPPERSCOPE_ZSH_COMPLETIONS})
