# Reads every built-in template and measures it, independently of the program (plain NumPy), so the
# sanitizers have nothing to see there.
if(NOT CROWD_SANITIZER)
    add_test(NAME templates_are_right
        COMMAND ${Python3_EXECUTABLE} -B
            "${CMAKE_SOURCE_DIR}/resources/authoring/check_templates.py")
    set_tests_properties(templates_are_right PROPERTIES LABELS resources TIMEOUT 600)
endif()
