# Benchmarks: built on request (`cmake --build --preset test --target parse_bench`), never part of ctest.
add_executable(parse_bench EXCLUDE_FROM_ALL bench/parse_bench.cpp)
target_link_libraries(parse_bench PRIVATE copperscope_model)
