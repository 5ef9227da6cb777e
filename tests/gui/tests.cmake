crowd_add_test(ROOM gui NAME tst_Console LINK crowd_app)
crowd_add_test(ROOM gui NAME tst_EditorAudience LINK crowd_app)
crowd_add_test(ROOM gui NAME tst_PaintAudience LINK crowd_widgets)
crowd_add_test(ROOM gui NAME tst_Recording LINK crowd_app)
crowd_add_test(ROOM gui NAME tst_ScriptBrush LINK crowd_app)
crowd_add_test(ROOM gui NAME tst_ViewportWindow LINK crowd_widgets)
crowd_add_test(ROOM gui NAME tst_WalkingCrowd LINK crowd_widgets)
# What is recorded in the window is replayed by interpreters of their own.
target_compile_definitions(tst_Recording PRIVATE
    CROWD_PROGRAM="$<TARGET_FILE:crowdbrush>"
    CROWD_PYTHON="${Python3_EXECUTABLE}"
    CROWD_PYTHON_FOLDER="$<TARGET_FILE_DIR:crowdbrush_module>")
add_dependencies(tst_Recording crowdbrush crowdbrush_module)
