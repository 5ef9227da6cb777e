crowd_add_tests(ROOM app LINK crowd_app TESTS
    tst_DescribedStruct
    tst_Interruptions
    tst_Language
    tst_LookMenu
    tst_MainWindow
    tst_MakeMovie
    tst_MemoryRelease
    tst_Panels
    tst_PictureFormats
    tst_QuickCard
    tst_RunRecall
    tst_SavePicture
    tst_SceneFiles
    tst_StepMenu
    tst_TimeSlider
    tst_Welcome
)
