copperscope_test(triangulate_test unit/tri/triangulate_test.cpp LABEL unit LINK copperscope_tri)
