# Documents, comments and decisions point to what is there, and the proof that this test can fail.
find_program(BASH bash REQUIRED)
add_test(NAME documents COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/check_documents.sh ${PROJECT_SOURCE_DIR})
add_test(NAME documents_catch_violations
    COMMAND ${BASH} ${CMAKE_CURRENT_LIST_DIR}/catches_violations.sh ${CMAKE_CURRENT_BINARY_DIR}/documents_scratch)
if(COPPERSCOPE_GUI)
    copperscope_test(guide_test documents/guide_test.cpp LABEL unit LINK copperscope_ui_workspace)
    target_compile_definitions(guide_test PRIVATE COPPERSCOPE_GUIDE="${PROJECT_SOURCE_DIR}/docs/guide")
    add_dependencies(guide_test copperscope)
endif()
set_tests_properties(documents documents_catch_violations PROPERTIES LABELS unit TIMEOUT 300)
