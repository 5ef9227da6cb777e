# What the documents say of the source is true. Nothing that is compiled.
add_test(NAME docs_names
    COMMAND ${Python3_EXECUTABLE} -B "${CMAKE_CURRENT_SOURCE_DIR}/docs/check_names.py")
set_tests_properties(docs_names PROPERTIES LABELS docs)
