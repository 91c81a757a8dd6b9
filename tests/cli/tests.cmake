foreach(name IN ITEMS cli_test inspection_commands_test export_commands_test bench_commands_test)
    copperscope_test(${name} cli/${name}.cpp LABEL cli LINK copperscope_options)
    add_dependencies(${name} copperscope)
    set_tests_properties(${name} PROPERTIES ENVIRONMENT "COPPERSCOPE_VALIDATION=abort")
endforeach()
target_compile_definitions(cli_test PRIVATE COPPERSCOPE_VERSION="${PROJECT_VERSION}")

copperscope_test(kicad_raster_test cli/kicad_raster_test.cpp LABEL cli LINK copperscope_options PNG::PNG)
add_dependencies(kicad_raster_test copperscope)
