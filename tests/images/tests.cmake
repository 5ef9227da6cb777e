crowd_add_test(ROOM images NAME tst_Pictures LINK crowd_app)
