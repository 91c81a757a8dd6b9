# What SECURITY.md promises, held against the program itself.
find_program(BASH bash REQUIRED)
add_test(NAME security_of_the_program
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/check_program.sh $<TARGET_FILE:copperscope>)
add_test(NAME security_of_a_run
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/watch_program.sh $<TARGET_FILE:copperscope>
            ${PROJECT_SOURCE_DIR}/resources/sample/ocp_tap_sa45_odb.tgz ${CMAKE_CURRENT_BINARY_DIR}/security_scratch)
add_test(NAME security_tests_catch_violations
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/catches_violations.sh ${CMAKE_CURRENT_BINARY_DIR}/security_planted)
set_tests_properties(security_of_the_program security_tests_catch_violations PROPERTIES LABELS unit TIMEOUT 120)
set_tests_properties(security_of_a_run PROPERTIES LABELS cli TIMEOUT 120 SKIP_RETURN_CODE 77)
