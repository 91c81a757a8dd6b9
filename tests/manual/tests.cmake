# Man pages and completions against the program's own --help, completion as a shell does it, and the forms of all that is installed.
find_program(BASH bash REQUIRED)
copperscope_test(manual_test manual/manual_test.cpp LABEL cli LINK copperscope_options)
target_compile_definitions(manual_test PRIVATE COPPERSCOPE_MANUAL="${COPPERSCOPE_MANUAL}")
add_dependencies(manual_test copperscope manual)

# What the distribution has to check such files with; without one of them a test is reported as not run.
function(copperscope_form_test name)
    add_test(NAME ${name} COMMAND ${BASH} ${CMAKE_CURRENT_SOURCE_DIR}/manual/check_form.sh ${ARGN})
    set_tests_properties(${name} PROPERTIES LABELS unit TIMEOUT 60 SKIP_RETURN_CODE 77)
endfunction()
set(desktop ${PROJECT_SOURCE_DIR}/resources/desktop/org.copperscope.Copperscope)
copperscope_form_test(form_of_man_pages man ${COPPERSCOPE_MANUAL})
copperscope_form_test(form_of_bash_completion bash ${COPPERSCOPE_MANUAL}/copperscope.bash)
copperscope_form_test(form_of_zsh_completion zsh ${COPPERSCOPE_MANUAL}/_copperscope)
if(COPPERSCOPE_GUI)
    copperscope_form_test(form_of_desktop_file desktop ${desktop}.desktop)
    copperscope_form_test(form_of_metainfo metainfo ${PROJECT_BINARY_DIR}/desktop/org.copperscope.Copperscope.metainfo.xml)
    copperscope_form_test(form_of_mime_types mime ${desktop}.mime.xml ${desktop}.desktop)
    copperscope_form_test(form_of_icons icons ${PROJECT_SOURCE_DIR}/resources/desktop/icons)
endif()

# Needs everything of the build that is installed: a build of single targets has it not.
add_test(NAME installs
    COMMAND ${BASH} ${CMAKE_CURRENT_SOURCE_DIR}/manual/check_install.sh ${CMAKE_COMMAND} ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR}/install_scratch)
set_tests_properties(installs PROPERTIES LABELS cli TIMEOUT 120)

add_test(NAME bill_of_materials COMMAND ${CMAKE_COMMAND} -DSBOM=${PROJECT_SOURCE_DIR}/scripts/sbom.sh -DPROGRAM=$<TARGET_FILE:copperscope>
    -P ${CMAKE_CURRENT_SOURCE_DIR}/manual/check_sbom.cmake)
set_tests_properties(bill_of_materials PROPERTIES LABELS cli TIMEOUT 120)
