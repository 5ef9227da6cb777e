crowd_add_tests(ROOM render LINK crowd_render TESTS
    tst_CrowdPlan
    tst_DrawnFiles
    tst_Renderer
)
