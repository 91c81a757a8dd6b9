# The window used at random (scripts/soak.sh), its work stopped at random moments, boards and windows opened and closed (scripts/cycles.sh).
# No test of ctest yet: not all of its runs end well.
add_executable(soak soak/action_log.cpp soak/actions.cpp soak/cancels.cpp soak/cycles.cpp soak/driver.cpp soak/loop_watch.cpp soak/main.cpp
    soak/resources.cpp soak/use.cpp)
set_target_properties(soak PROPERTIES AUTOMOC ON)
target_link_libraries(soak PRIVATE copperscope_options copperscope_ui ui_test_support copperscope_test_locations Qt6::Test)
target_precompile_headers(soak REUSE_FROM copperscope_window_headers)
