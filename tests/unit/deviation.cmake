surpass_test(unit_deviation SOURCES deviation_test.cpp LABELS unit)
