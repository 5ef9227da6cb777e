crowd_add_test(ROOM model NAME tst_Population LINK crowd_model)
