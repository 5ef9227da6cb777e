crowd_add_tests(ROOM widgets LINK crowd_widgets TESTS
    tst_BehaviourDocks
    tst_BrushTool
    tst_ColourDock
    tst_DockControls
    tst_Docks
    tst_IndividualDock
    tst_KeepPose
    tst_Navigation
    tst_PathDrawing
    tst_PickDrag
    tst_RulePanel
    tst_SelectTool
    tst_ToolController
    tst_Transport
    tst_ViewportCamera
    tst_WheelInPanels
)
