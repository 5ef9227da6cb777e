crowd_add_tests(ROOM app LINK crowd_app TESTS
    tst_CommandLine
    tst_Interruptions
    tst_MainWindow
    tst_Panels
    tst_SceneFiles
    tst_StepMenu
    tst_Welcome
)
crowd_define_for_test(app tst_CommandLine CROWD_PROGRAM="$<TARGET_FILE:crowdbrush>")
add_dependencies(test_app crowdbrush)
