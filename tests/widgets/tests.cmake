crowd_add_test(ROOM widgets NAME tst_Docks LINK crowd_widgets)
crowd_add_test(ROOM widgets NAME tst_ToolController LINK crowd_widgets)
    crowd_add_test(ROOM widgets NAME tst_Transport LINK crowd_widgets)
        crowd_add_test(ROOM widgets NAME tst_ViewportCamera LINK crowd_widgets)
