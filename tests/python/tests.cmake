# The Python module, in the program's own interpreter and in a plain python3. The sanitizers' runtime
# cannot be loaded into a plain one, so only the program's own is run under them.
add_test(NAME python_in_program
    COMMAND crowdbrush script "${CMAKE_CURRENT_SOURCE_DIR}/python/run_tests.py")
set(python_tests python_in_program)
if(NOT CROWD_SANITIZER)
    add_test(NAME python_plain
        COMMAND ${Python3_EXECUTABLE} -B "${CMAKE_CURRENT_SOURCE_DIR}/python/run_tests.py")
    list(APPEND python_tests python_plain)
endif()
set_tests_properties(${python_tests} PROPERTIES LABELS python TIMEOUT 300)
set_tests_properties(${python_tests} PROPERTIES ENVIRONMENT
    "PYTHONPATH=$<TARGET_FILE_DIR:crowdbrush_module>;PYTHONDONTWRITEBYTECODE=1")
