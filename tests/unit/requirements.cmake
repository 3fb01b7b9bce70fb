surpass_test(unit_requirements SOURCES requirements_test.cpp LABELS unit)
