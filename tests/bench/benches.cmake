# Benchmarks: built on request (`cmake --build --preset test --target parse_bench`), never part of ctest.
add_executable(parse_bench EXCLUDE_FROM_ALL bench/parse_bench.cpp)
target_link_libraries(parse_bench PRIVATE copperscope_model)
add_executable(shadow_bench EXCLUDE_FROM_ALL bench/shadow_bench.cpp)
target_link_libraries(shadow_bench PRIVATE copperscope_options copperscope_app_common copperscope_render)
if(COPPERSCOPE_GUI)
    add_executable(selection_bench EXCLUDE_FROM_ALL bench/selection_bench.cpp)
    target_link_libraries(selection_bench PRIVATE copperscope_options copperscope_ui ui_test_support)
endif()
