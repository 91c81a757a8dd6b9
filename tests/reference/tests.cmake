# The reader against a painter that shares no code with it (tests/reference/raster.h).
copperscope_test(reference_test reference/reference_test.cpp LABEL unit LINK copperscope_model)
target_sources(reference_test PRIVATE
    reference/document_painter.cpp reference/odb_painter.cpp reference/raster.cpp reference/symbols.cpp)
target_include_directories(reference_test PRIVATE ${CMAKE_CURRENT_SOURCE_DIR})
copperscope_test(gerber_conformance_test reference/gerber_conformance_test.cpp LABEL unit LINK copperscope_model_formats)
target_sources(gerber_conformance_test PRIVATE
    reference/document_painter.cpp reference/gerber_expected.cpp reference/raster.cpp reference/svg_painter.cpp)
