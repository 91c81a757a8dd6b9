# Tests that draw: on any Vulkan device, in CI the software one. A message of the validation layer ends them.
add_library(copperscope_gpu_test_support STATIC gpu/gpu_fixture.cpp gpu/synthetic_board.cpp)
target_link_libraries(copperscope_gpu_test_support PUBLIC copperscope_options copperscope_render copperscope_tri)

add_custom_target(gpu_tests)  # all of them, for scripts/gpu-check.sh
foreach(name backends calibrate component_bodies section_plane device element_state faults flat_picture highlight memory milling_view panel pipelines raster sample_board swapchain view)
    add_dependencies(gpu_tests ${name}_test)
    copperscope_test(${name}_test gpu/${name}_test.cpp LABEL gpu LINK copperscope_gpu_test_support copperscope_model)
    set_tests_properties(${name}_test PROPERTIES ENVIRONMENT COPPERSCOPE_VALIDATION=abort)
endforeach()

add_dependencies(gpu_tests tri_gpu_test)
copperscope_test(tri_gpu_test gpu/triangulator_test.cpp LABEL gpu LINK copperscope_tri_oracle)
target_compile_definitions(tri_gpu_test PRIVATE
    COPPERSCOPE_GLSLANG="${GLSLANG_VALIDATOR}"
    COPPERSCOPE_PREDICATES_SHADER="${CMAKE_CURRENT_SOURCE_DIR}/gpu/predicates.comp.glsl")
set_tests_properties(tri_gpu_test PROPERTIES ENVIRONMENT COPPERSCOPE_VALIDATION=abort)

# What shaders and C++ must agree on.
copperscope_test(shader_layout_test gpu/shader_layout_test.cpp LABEL unit LINK copperscope_shaders)
target_compile_definitions(shader_layout_test PRIVATE
    COPPERSCOPE_GLSLANG="${GLSLANG_VALIDATOR}"
    COPPERSCOPE_LAYOUT_SHADER="${CMAKE_CURRENT_SOURCE_DIR}/gpu/shader_layout.comp.glsl")
