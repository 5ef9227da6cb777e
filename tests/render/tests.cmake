crowd_add_tests(ROOM render LINK crowd_render nlohmann_json::nlohmann_json TESTS
    tst_AirAndTone
    tst_Aovs
    tst_Cartoon
    tst_CrowdPlan
    tst_DrawnFiles
    tst_DrawnMaterials
    tst_OddFiles
    tst_Highlights
    tst_Lens
    tst_Lights
    tst_PaintedLooks
    tst_Relief
    tst_Renderer
    tst_SceneLook
    tst_Shadows
    tst_SmoothEdges
)
