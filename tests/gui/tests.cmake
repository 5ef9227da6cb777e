crowd_add_tests(ROOM gui LINK crowd_app TESTS
    tst_Console
    tst_EditorAudience
    tst_PaintAudience
    tst_PropertyLegend
    tst_Recording
    tst_Scenarios
    tst_ScriptBrush
    tst_ViewportWindow
    tst_WalkingCrowd
)
# What is recorded in the window is replayed by interpreters of their own.
crowd_define_for_test(gui tst_Recording
    CROWD_PROGRAM="$<TARGET_FILE:crowdbrush>"
    CROWD_PYTHON="${Python3_EXECUTABLE}"
    CROWD_PYTHON_FOLDER="$<TARGET_FILE_DIR:crowdbrush_module>")
add_dependencies(test_gui crowdbrush crowdbrush_module)
