crowd_add_test(ROOM behavior NAME tst_CrowdSimulation LINK crowd_behavior)
crowd_add_test(ROOM behavior NAME tst_Session LINK crowd_behavior)
crowd_add_test(ROOM behavior NAME tst_Validation LINK crowd_behavior)
