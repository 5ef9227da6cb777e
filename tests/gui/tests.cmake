crowd_add_test(ROOM gui NAME tst_Console LINK crowd_app)
crowd_add_test(ROOM gui NAME tst_EditorAudience LINK crowd_app)
crowd_add_test(ROOM gui NAME tst_PaintAudience LINK crowd_widgets)
crowd_add_test(ROOM gui NAME tst_ViewportWindow LINK crowd_widgets)
