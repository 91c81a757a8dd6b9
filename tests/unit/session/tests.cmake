# What users set for a board, and the file it is kept in.
copperscope_test(session_test unit/session/session_test.cpp LABEL unit LINK copperscope_model)
