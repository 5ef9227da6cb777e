crowd_add_test(ROOM model NAME tst_Population LINK crowd_model)
crowd_add_test(ROOM model NAME tst_Pose LINK crowd_model)
crowd_add_test(ROOM model NAME tst_SceneDocument LINK crowd_model)
crowd_add_test(ROOM model NAME tst_ProjectFile LINK crowd_model)
