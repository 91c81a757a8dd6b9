copperscope_test(cli_test cli/cli_test.cpp LABEL cli LINK copperscope_options)
add_dependencies(cli_test copperscope)
target_compile_definitions(cli_test PRIVATE COPPERSCOPE_VERSION="${PROJECT_VERSION}")
set_tests_properties(cli_test PROPERTIES ENVIRONMENT "COPPERSCOPE_VALIDATION=abort")

copperscope_test(kicad_raster_test cli/kicad_raster_test.cpp LABEL cli LINK copperscope_options PNG::PNG)
add_dependencies(kicad_raster_test copperscope)
