crowd_add_test(ROOM render NAME tst_Renderer LINK crowd_render)
