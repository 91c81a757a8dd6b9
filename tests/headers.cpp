// Nothing of its own: carries the headers that all tests share (tests/CMakeLists.txt).
