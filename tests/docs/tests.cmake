# What the documents say of the source is true. Nothing that is compiled.
add_test(NAME docs_names
    COMMAND ${Python3_EXECUTABLE} -B "${CMAKE_CURRENT_SOURCE_DIR}/docs/check_names.py")
add_test(NAME docs_recipes
    COMMAND ${Python3_EXECUTABLE} -B "${CMAKE_CURRENT_SOURCE_DIR}/docs/check_recipes.py")
set_tests_properties(docs_names docs_recipes PROPERTIES LABELS docs)
