# Hostile input (docs/testing.md): the table of targets, a test that runs each on truncated and changed seeds, and with the preset
# `fuzz` one libFuzzer program per target.
add_library(copperscope_fuzz_targets STATIC fuzz/contours.cpp fuzz/seeds.cpp fuzz/tar.cpp fuzz/targets.cpp)
target_link_libraries(copperscope_fuzz_targets PUBLIC copperscope_options copperscope_model
    copperscope_tri_oracle PRIVATE copperscope_test_locations)

copperscope_test(hostile_input_test fuzz/hostile_input_test.cpp LABEL unit LINK copperscope_fuzz_targets)

if(COPPERSCOPE_FUZZ)
    add_executable(write_seeds fuzz/write_seeds.cpp)
    target_link_libraries(write_seeds PRIVATE copperscope_fuzz_targets)
    add_custom_target(fuzzers DEPENDS write_seeds)
    file(STRINGS fuzz/targets.cpp rows REGEX "^        {\"")
    foreach(row IN LISTS rows)
        string(REGEX REPLACE "^ *{\"([a-z0-9_]+)\".*" "\\1" name "${row}")
        add_executable(fuzz_${name} fuzz/fuzz_one.cpp)
        target_compile_definitions(fuzz_${name} PRIVATE COPPERSCOPE_FUZZ_TARGET="${name}")
        target_link_libraries(fuzz_${name} PRIVATE copperscope_fuzz_targets)
        target_link_options(fuzz_${name} PRIVATE -fsanitize=fuzzer)
        add_dependencies(fuzzers fuzz_${name})
    endforeach()
endif()
