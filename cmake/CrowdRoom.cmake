# crowd_add_room(NAME room [COLD] PCH header... | PCH_OF room SOURCES file... LINK target...
#     PRIVATE_LINK target...)
# One static library per room. What a room may know is what it links: the linker enforces the design.
# Compiled headers take twenty seconds and 400 MB each: a room that is compiled with all definitions of
# another one, such as Qt's of its modules, takes that one's (PCH_OF).
# A COLD room only waits for people and asks other rooms: it is compiled in half the time, with less
# optimisation; under a sanitizer, whose checks are most of what the compiler works at, with none. Who
# shares compiled headers is cold like the other, or neither is.
function(crowd_add_room)
    cmake_parse_arguments(ROOM "COLD" "NAME;PCH_OF" "PCH;SOURCES;LINK;PRIVATE_LINK" ${ARGN})
    add_library(crowd_${ROOM_NAME} STATIC ${ROOM_SOURCES})
    # A unity build takes the files of a folder together: in a folder, and nowhere else, names in
    # unnamed namespaces must differ.
    set_target_properties(crowd_${ROOM_NAME} PROPERTIES UNITY_BUILD_MODE GROUP)
    foreach(source IN LISTS ROOM_SOURCES)
        cmake_path(GET source PARENT_PATH folder)
        if(folder AND NOT IS_ABSOLUTE "${folder}")
            set_property(SOURCE ${source} PROPERTY UNITY_GROUP "${folder}")
        endif()
    endforeach()
    target_link_libraries(crowd_${ROOM_NAME} PUBLIC crowd_options ${ROOM_LINK} PRIVATE ${ROOM_PRIVATE_LINK})
    if(ROOM_COLD)
        target_compile_options(crowd_${ROOM_NAME} PRIVATE $<$<CONFIG:Release>:-O1>
            $<$<BOOL:${CROWD_SANITIZER}>:-O0>)
    endif()
    if(ROOM_PCH OR ROOM_PCH_OF)
        if(ROOM_PCH_OF)
            target_precompile_headers(crowd_${ROOM_NAME} REUSE_FROM crowd_${ROOM_PCH_OF})
        else()
            target_precompile_headers(crowd_${ROOM_NAME} PRIVATE ${ROOM_PCH})
        endif()
        target_compile_options(crowd_${ROOM_NAME} PRIVATE
            $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    endif()
endfunction()
