# The Python module: all of it in a plain python3, and what may differ there in the program's own
# interpreter. The sanitizers' runtime cannot be loaded into a plain one.
add_test(NAME python_in_program
    COMMAND crowdbrush script "${CMAKE_CURRENT_SOURCE_DIR}/python/run_tests.py" --smoke)
set(python_tests python_in_program)
if(NOT CROWD_SANITIZER)
    add_test(NAME python_plain
        COMMAND ${Python3_EXECUTABLE} -B "${CMAKE_CURRENT_SOURCE_DIR}/python/run_tests.py")
    list(APPEND python_tests python_plain)
    set(plain ";CROWD_PLAIN_PYTHON=1")
endif()
set_tests_properties(${python_tests} PROPERTIES LABELS python TIMEOUT 300 COST 50)
set_tests_properties(${python_tests} PROPERTIES ENVIRONMENT
    "PYTHONPATH=$<TARGET_FILE_DIR:crowdbrush_module>;PYTHONDONTWRITEBYTECODE=1${plain}")
# The stubs beside the module, and the examples by them: nothing that is compiled.
find_program(MYPY mypy)
if(MYPY AND NOT CROWD_SANITIZER)
    set(typed ${MYPY} --no-incremental --cache-dir=/dev/null
        --python-executable ${Python3_EXECUTABLE})
    add_test(NAME python_stubs_typed
        COMMAND ${typed} --strict "${CMAKE_SOURCE_DIR}/app/python/crowdbrush.pyi")
    add_test(NAME python_examples_typed
        COMMAND ${typed} --check-untyped-defs "${CMAKE_CURRENT_SOURCE_DIR}/python/examples")
    set_tests_properties(python_stubs_typed python_examples_typed PROPERTIES
        LABELS python TIMEOUT 300 ENVIRONMENT "MYPYPATH=${CMAKE_SOURCE_DIR}/app/python")
endif()

# What must stay as it is, byte for byte. Only the release build: that is what the recordings are of.
if(NOT CROWD_SANITIZER)
    add_test(NAME golden_recordings
        COMMAND crowdbrush script "${CMAKE_CURRENT_SOURCE_DIR}/golden/golden.py")
    set_tests_properties(golden_recordings PROPERTIES LABELS python TIMEOUT 300
        ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
endif()
