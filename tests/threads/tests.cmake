# What several threads share. Under the thread sanitizer these alone are built and run:
# ./dev test tsan
crowd_add_tests(ROOM threads LINK crowd_tasks crowd_scripts crowd_behavior TESTS
    tst_BackgroundTask
    tst_ScriptThreads
    tst_SessionPlayer
    tst_SharedColumns
    tst_SurfaceThreads
)
