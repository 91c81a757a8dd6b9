# The window used at random (scripts/soak.sh), its work stopped at random moments, boards and windows opened and closed (scripts/cycles.sh).
# As tests short forms of them; what led to a failure is on stderr.
add_executable(soak soak/action_log.cpp soak/actions.cpp soak/cancels.cpp soak/cycles.cpp soak/driver.cpp soak/loop_watch.cpp soak/main.cpp
    soak/resources.cpp soak/use.cpp)
set_target_properties(soak PROPERTIES AUTOMOC ON)
target_link_libraries(soak PRIVATE copperscope_options copperscope_ui ui_test_support copperscope_test_locations Qt6::Test)
target_precompile_headers(soak REUSE_FROM copperscope_window_headers)

function(soak_test mode)
    copperscope_add_test(soak_${mode} ui soak ${mode} ${ARGN})
    set_tests_properties(soak_${mode} PROPERTIES ENVIRONMENT "COPPERSCOPE_VALIDATION=abort" RESOURCE_LOCK display)
endfunction()
set(sample ${PROJECT_SOURCE_DIR}/resources/sample/ocp_tap_sa45_odb.tgz)
soak_test(cancels --seed 7 --count 16 ${sample} ${CMAKE_CURRENT_SOURCE_DIR}/data/boards/opencellular_sync.tgz)
soak_test(use --seed 3 --count 150 ${sample} ${CMAKE_CURRENT_SOURCE_DIR}/data/odb/everything)
soak_test(cycles --count 40 ${CMAKE_CURRENT_SOURCE_DIR}/data/odb/panel ${CMAKE_CURRENT_SOURCE_DIR}/data/odb/everything)
# The validation layer keeps 13 kB of each window for itself.
set_tests_properties(soak_cycles PROPERTIES ENVIRONMENT "")
