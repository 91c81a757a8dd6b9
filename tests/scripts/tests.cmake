# The set-up functions of the front door, on made-up machines.
find_program(BASH bash REQUIRED)
add_test(NAME setup
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/setup_test.sh ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/setup_scratch)
set_tests_properties(setup PROPERTIES LABELS unit TIMEOUT 60)

add_test(NAME reliability
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/reliability_test.sh ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/reliability_scratch)
set_tests_properties(reliability PROPERTIES LABELS unit TIMEOUT 60)

add_test(NAME configure_once
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/build_test.sh ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/build_scratch)
set_tests_properties(configure_once PROPERTIES LABELS unit TIMEOUT 60)

add_test(NAME package_options
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/package_test.sh ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/package_scratch)
set_tests_properties(package_options PROPERTIES LABELS unit TIMEOUT 60)

add_test(NAME blanks_in_paths COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/blanks_test.sh ${PROJECT_SOURCE_DIR})
set_tests_properties(blanks_in_paths PROPERTIES LABELS unit TIMEOUT 60)

if(COPPERSCOPE_GUI)
    add_test(NAME large_board COMMAND ${BASH} ${PROJECT_SOURCE_DIR}/scripts/large-board.sh --quick $<TARGET_FILE:copperscope>)
    set_tests_properties(large_board PROPERTIES LABELS cli TIMEOUT 300)
endif()
