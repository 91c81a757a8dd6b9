foreach(name area_pieces colour_ramp edge_grid hole_cells insets lets board_model camera layer_style round_holes standard_model)
    copperscope_test(${name}_test unit/render/${name}_test.cpp LABEL unit LINK copperscope_render)
endforeach()
