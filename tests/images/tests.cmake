crowd_add_tests(ROOM images LINK crowd_app TESTS
    tst_LensWish
    tst_LookWish
    tst_MovieFile
    tst_Pictures
)
