surpass_test(evaluate_test SOURCES evaluate_test.cpp evaluate_stencil_test.cpp LABELS unit)
