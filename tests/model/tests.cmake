crowd_add_tests(ROOM model
    LINK crowd_model meshoptimizer::meshoptimizer nlohmann_json::nlohmann_json
    TESTS
    tst_Autosave
    tst_Bake
    tst_BakeAgainstBlender
    tst_BrushAnimation
    tst_BrushColour
    tst_BrushCreate
    tst_BrushExchange
    tst_BrushGround
    tst_BrushIndividuals
    tst_BrushNeighbours
    tst_BrushOrientation
    tst_BrushReach
    tst_BrushRetake
    tst_BrushSampler
    tst_BrushSettings
    tst_BrushStroke
    tst_BrushTheatre
    tst_CameraTrack
    tst_ClipRoles
    tst_CollectAssets
    tst_Environment
    tst_GltfAssets
    tst_GltfClips
    tst_GltfDraco
    tst_GltfFuzz
    tst_GltfHostile
    tst_GltfImport
    tst_GltfMaterials
    tst_GltfMeshes
    tst_GltfSkins
    tst_GltfSpecClips
    tst_GltfSpecFiles
    tst_GltfSpecMeshes
    tst_GroundSpeed
    tst_Impostors
    tst_Features
    tst_Relations
    tst_Groups
    tst_ImportProposal
    tst_Lasso
    tst_LastStrokes
    tst_LightCues
    tst_DayLight
    tst_LightList
    tst_LookList
    tst_Message
    tst_Neighbours
    tst_PickScene
    tst_PlaceShape
    tst_Population
    tst_Pose
    tst_ProjectFile
    tst_ProjectMutations
    tst_PropertyPaint
    tst_Properties
    tst_RuleFlaws
    tst_RuleSequence
    tst_SceneDocument
    tst_SceneMembers
    tst_ShownText
    tst_StageRays
    tst_SlotColour
    tst_States
    tst_StatesFeaturesRelations
    tst_TakeFiles
    tst_Timeline
    tst_UndoMemory
    tst_WholeFile
)

add_executable(pack_ground tools/pack_ground.cpp)
set_target_properties(pack_ground PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${CMAKE_BINARY_DIR}/tests")
target_link_libraries(pack_ground PRIVATE crowd_options draco::draco_static)
crowd_define_for_test(model tst_GltfDraco CROWD_PACK_GROUND="$<TARGET_FILE:pack_ground>")
add_dependencies(test_model pack_ground)

# The address sanitizer's program has baking checked here, and nowhere else (see model/CMakeLists.txt):
# these come in the place of the library's.
if(CROWD_SANITIZER STREQUAL "address")
    list(TRANSFORM CROWD_HOT_BAKING PREPEND "${CMAKE_SOURCE_DIR}/model/" OUTPUT_VARIABLE checked_baking)
    target_sources(test_model PRIVATE ${checked_baking})
    set_source_files_properties(${checked_baking} PROPERTIES
        COMPILE_OPTIONS "${CROWD_CHECKS}" SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endif()
