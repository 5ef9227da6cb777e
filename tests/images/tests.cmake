crowd_add_tests(ROOM images LINK crowd_app OpenEXR::OpenEXR TESTS
    tst_LensWish
    tst_LookWish
    tst_MovieFile
    tst_PicturePasses
    tst_PictureQuality
    tst_Pictures
    tst_PictureTiles
)
