# The layering of docs/architecture.md as a test, and the proof that this test can fail.
add_test(NAME architecture
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -P ${CMAKE_CURRENT_LIST_DIR}/check_includes.cmake)
add_test(NAME architecture_catches_violations
    COMMAND ${CMAKE_COMMAND} -DWORK=${CMAKE_CURRENT_BINARY_DIR}/architecture_scratch
            -P ${CMAKE_CURRENT_LIST_DIR}/catches_violations.cmake)
set_tests_properties(architecture architecture_catches_violations PROPERTIES LABELS unit TIMEOUT 300)

# The words of the trade (words.txt) as a test, and the proof that this test can fail.
add_test(NAME vocabulary
    COMMAND ${CMAKE_COMMAND} -DROOT=${PROJECT_SOURCE_DIR} -DPROGRAM=$<TARGET_FILE:copperscope>
            -P ${CMAKE_CURRENT_LIST_DIR}/vocabulary.cmake)
add_test(NAME vocabulary_catches_violations
    COMMAND ${CMAKE_COMMAND} -DWORK=${CMAKE_CURRENT_BINARY_DIR}/vocabulary_scratch
            -P ${CMAKE_CURRENT_LIST_DIR}/vocabulary_catches_violations.cmake)
set_tests_properties(vocabulary vocabulary_catches_violations PROPERTIES LABELS unit TIMEOUT 120)
