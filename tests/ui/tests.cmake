# The workbench, driven by clicks and keys. What touches the window runs on the display of ./test (swapchain) and again without one (through
# memory), on a screen of the same size: the platform's own is 800 pixels wide, less than some windows.
set(offscreen QT_QPA_PLATFORM=offscreen:configfile=${CMAKE_CURRENT_LIST_DIR}/offscreen.json)
function(copperscope_ui_test name)
    copperscope_test(${name}_test ui/${name}_test.cpp LABEL ui LINK copperscope_ui ui_test_support)
    # One at a time: windows on one display take the keyboard from each other.
    set_tests_properties(${name}_test PROPERTIES ENVIRONMENT "COPPERSCOPE_VALIDATION=abort" RESOURCE_LOCK display)
    copperscope_add_test(${name}_offscreen_test ui ${name}_test)
    set_tests_properties(${name}_offscreen_test PROPERTIES
        ENVIRONMENT "${offscreen};COPPERSCOPE_VALIDATION=abort")
endfunction()

add_library(ui_test_support STATIC ui/window_fixture.cpp)
target_link_libraries(ui_test_support PUBLIC copperscope_ui Qt6::Test)
copperscope_ui_test(main_window)
copperscope_ui_test(go_to_message)
copperscope_ui_test(board_views)
copperscope_ui_test(clearances)
copperscope_ui_test(distances)
copperscope_ui_test(panels)
copperscope_ui_test(element_picture)
copperscope_ui_test(frame_display)
copperscope_ui_test(histogram_view)
copperscope_ui_test(kept_views)
copperscope_ui_test(inspection)
copperscope_ui_test(keyboard)
copperscope_ui_test(latency)
copperscope_ui_test(measuring)
copperscope_ui_test(measuring_tools)
copperscope_ui_test(net_check)
copperscope_ui_test(nets)
copperscope_ui_test(parts)
copperscope_ui_test(probing)
copperscope_ui_test(search)
copperscope_ui_test(sections)
copperscope_ui_test(stack_view)
copperscope_ui_test(thickness)
copperscope_ui_test(view_cube)

copperscope_test(ui_actions_test ui/actions_test.cpp LABEL ui LINK copperscope_ui)
copperscope_test(ui_camera_controller_test ui/camera_controller_test.cpp LABEL ui LINK copperscope_ui)
copperscope_test(ui_label_placing_test ui/label_placing_test.cpp LABEL ui LINK copperscope_ui)
copperscope_test(ui_loader_test ui/loader_test.cpp LABEL ui LINK copperscope_ui)
copperscope_test(ui_settings_test ui/settings_test.cpp LABEL ui LINK copperscope_ui)
copperscope_test(ui_workspace_test ui/workspace_test.cpp LABEL ui LINK copperscope_ui)
set_tests_properties(ui_actions_test ui_camera_controller_test ui_loader_test ui_settings_test ui_workspace_test PROPERTIES
    ENVIRONMENT "${offscreen}")

# The window on screens whose pixels are finer than its coordinates.
copperscope_test(hidpi_test ui/hidpi_test.cpp LABEL ui LINK copperscope_ui ui_test_support)
set_tests_properties(hidpi_test PROPERTIES RESOURCE_LOCK display
    ENVIRONMENT "COPPERSCOPE_VALIDATION=abort;QT_SCALE_FACTOR=1.5")
copperscope_add_test(hidpi_offscreen_test ui hidpi_test)
set_tests_properties(hidpi_offscreen_test PROPERTIES
    ENVIRONMENT "${offscreen};COPPERSCOPE_VALIDATION=abort;QT_SCALE_FACTOR=2")
