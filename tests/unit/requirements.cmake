surpass_test(unit_requirements SOURCES many_requirements_test.cpp requirements_test.cpp requirement_tangents_test.cpp
             requirement_words_test.cpp LABELS unit)
