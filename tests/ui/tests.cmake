# The workbench, driven by clicks and keys on the display of ./test (swapchain). What is about the window, its views and their canvas runs again
# without a display (through memory); panels and dialogs are the same there. The screen is of the same size then: the platform's own is 800 pixels
# wide, less than some windows.
set(offscreen QT_QPA_PLATFORM=offscreen:configfile=${CMAKE_CURRENT_LIST_DIR}/offscreen.json)
function(copperscope_ui_test test file)
    string(REGEX REPLACE "_test$" "" name ${test})
    copperscope_test(${name}_test ui/${file} LABEL ui LINK copperscope_ui ui_test_support)
    # One at a time: windows on one display take the keyboard from each other. So they come first, or a processor waits for the last of them.
    set_tests_properties(${name}_test PROPERTIES ENVIRONMENT "COPPERSCOPE_VALIDATION=abort" RESOURCE_LOCK display COST 1000)
    if(file MATCHES "^((canvas|shell|views)/|[^/]*$)")
        copperscope_add_test(${name}_offscreen_test ui ${name}_test)
        set_tests_properties(${name}_offscreen_test PROPERTIES
            ENVIRONMENT "${offscreen};COPPERSCOPE_VALIDATION=abort")
    endif()
endfunction()

add_library(ui_test_support STATIC ui/window_fixture.cpp)
target_link_libraries(ui_test_support PUBLIC copperscope_ui copperscope_test_locations Qt6::Test)
file(GLOB_RECURSE tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_LIST_DIR} ${CMAKE_CURRENT_LIST_DIR}/*_test.cpp)
foreach(test IN LISTS tests)
    file(STRINGS ${CMAKE_CURRENT_LIST_DIR}/${test} uses_window REGEX "window_fixture\\.h" LIMIT_COUNT 1)
    cmake_path(GET test STEM name)
    if(name MATCHES "^(hidpi|small_screen)_test$")
        continue()  # below
    elseif(uses_window)
        copperscope_ui_test(${name} ${test})
    else()
        copperscope_test(ui_${name} ui/${test} LABEL ui LINK copperscope_ui)
        set_tests_properties(ui_${name} PROPERTIES ENVIRONMENT "${offscreen}")
    endif()
endforeach()

# The window on screens whose pixels are finer than its coordinates.
copperscope_test(hidpi_test ui/hidpi_test.cpp LABEL ui LINK copperscope_ui ui_test_support)
set_tests_properties(hidpi_test PROPERTIES RESOURCE_LOCK display
    ENVIRONMENT "COPPERSCOPE_VALIDATION=abort;QT_SCALE_FACTOR=1.5")
copperscope_add_test(hidpi_offscreen_test ui hidpi_test)
set_tests_properties(hidpi_offscreen_test PROPERTIES
    ENVIRONMENT "${offscreen};COPPERSCOPE_VALIDATION=abort;QT_SCALE_FACTOR=2")

# What opens on a screen of 800 by 600 pixels.
copperscope_test(ui_small_screen_test ui/small_screen_test.cpp LABEL ui LINK copperscope_ui)
set_tests_properties(ui_small_screen_test PROPERTIES
    ENVIRONMENT "QT_QPA_PLATFORM=offscreen:configfile=${CMAKE_CURRENT_LIST_DIR}/small_screen.json")
