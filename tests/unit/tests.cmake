# A test of one source file stands below unit/ where its source does: unit/model/board/copies_test.cpp for model/board/copies.h. Adding one
# needs no line here.
add_library(copperscope_tri_oracle STATIC unit/tri/gpu/oracle.cpp)  # shaders/tri on the processor, which devices are compared with
target_link_libraries(copperscope_tri_oracle PUBLIC copperscope_tri_gpu)
# Shaders index vectors by uint, as they must, which Clang takes for a conversion of sign where they are C++. Options of a source follow all others.
set_source_files_properties(unit/tri/gpu/oracle.cpp PROPERTIES COMPILE_OPTIONS $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>)

set(links_model copperscope_model)
set(links_render copperscope_render copperscope_model)
set(links_tri copperscope_tri_oracle)
set(links_ui copperscope_ui)
set(links_app copperscope_app)
file(GLOB_RECURSE tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/*_test.cpp)
if(COPPERSCOPE_FUZZ)
    list(FILTER tests EXCLUDE REGEX "/glb_export_test\\.cpp$")
endif()
foreach(test IN LISTS tests)
    string(REGEX REPLACE "/.*" "" area ${test})
    cmake_path(GET test STEM name)
    if(test MATCHES "^(ui|tri|model/formats/(odb|kicad))/")  # their names occur elsewhere too
        cmake_path(GET CMAKE_MATCH_1 FILENAME prefix)
        set(name ${prefix}_${name})
    endif()
    if(COPPERSCOPE_GUI OR NOT area STREQUAL ui)
        copperscope_test(${name} unit/${test} LABEL unit LINK ${links_${area}})
    endif()
endforeach()
target_link_libraries(png_test PRIVATE PNG::PNG)
if(TARGET glb_export_test)
    target_link_libraries(glb_export_test PRIVATE ${TINYGLTF})
endif()
foreach(test odb_parse_memory_test glb_memory_test)
    target_link_libraries(${test} PRIVATE copperscope_counted_memory)
    if(COPPERSCOPE_SANITIZE)
        # Sanitizers bring operators new of their own.
        set_tests_properties(${test} PROPERTIES DISABLED TRUE)
    endif()
endforeach()
