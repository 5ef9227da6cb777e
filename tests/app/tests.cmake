crowd_add_tests(ROOM app LINK crowd_app TESTS
    tst_CommandLine
    tst_MainWindow
    tst_SceneFiles
    tst_StepMenu
    tst_Welcome
)
# Of one file alone, so that the programs can share their compiled headers.
set_property(SOURCE app/tst_CommandLine.cpp PROPERTY COMPILE_DEFINITIONS
    CROWD_PROGRAM="$<TARGET_FILE:crowdbrush>")
add_dependencies(test_app crowdbrush)
