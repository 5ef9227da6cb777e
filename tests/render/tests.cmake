crowd_add_test(ROOM render NAME tst_CrowdPlan LINK crowd_render)
crowd_add_test(ROOM render NAME tst_Renderer LINK crowd_render)
