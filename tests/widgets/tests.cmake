if(EXISTS "${CMAKE_SOURCE_DIR}/model/brush/Stroke.cpp")
crowd_add_test(ROOM widgets NAME tst_Transport LINK crowd_widgets)
crowd_add_test(ROOM widgets NAME tst_ViewportCamera LINK crowd_widgets)
endif()
