copperscope_test(triangulate_test unit/tri/triangulate_test.cpp LABEL unit LINK copperscope_tri)
copperscope_test(predicates_test unit/tri/predicates_test.cpp LABEL unit LINK copperscope_tri)
copperscope_test(verify_test unit/tri/verify_test.cpp LABEL unit LINK copperscope_tri)
copperscope_test(tri_property_test property/tri_property_test.cpp LABEL unit LINK copperscope_tri)
