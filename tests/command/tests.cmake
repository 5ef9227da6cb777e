# The program from outside. It needs no display, so these run beside the tests of windows.
crowd_add_tests(ROOM command LINK crowd_model Qt6::Gui TESTS
    tst_CommandLine
    tst_RenderCommand
)
target_compile_definitions(test_command PRIVATE CROWD_PROGRAM="$<TARGET_FILE:crowdbrush>")
add_dependencies(test_command crowdbrush)
