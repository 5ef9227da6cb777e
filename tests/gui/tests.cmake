crowd_add_test(ROOM gui NAME tst_ViewportWindow LINK crowd_widgets)
