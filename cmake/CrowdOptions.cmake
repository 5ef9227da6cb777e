# Warnings, sanitizers and floating-point rules, in one INTERFACE target that every room links.
set(CROWD_SANITIZER "" CACHE STRING "Sanitizer: empty, 'address' (with undefined) or 'thread'")

find_program(CROWD_CCACHE ccache)
if(CROWD_CCACHE)
    # The sloppiness lets ccache work together with precompiled headers.
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_NOHASHDIR=1
        "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}"
        CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
        ${CROWD_CCACHE})
endif()

# Every program holds most of the rooms: mold links one in a second, the usual linker in many.
find_program(CROWD_MOLD mold)
if(CROWD_MOLD)
    # Without RELRO: where only zeroed thread-local variables come before a page's first section, mold
    # 1.10 begins that segment in the page before, which nobody maps, and the program does not start
    # ("cannot apply additional memory protection after relocation").
    # Without a build id: for some sizes of the program mold 1.10 never ends making it.
    add_link_options(-fuse-ld=mold -Wl,-z,norelro,--build-id=none)
endif()

add_library(crowd_options INTERFACE)
target_compile_options(crowd_options INTERFACE
    -Wall -Wextra -Wconversion -Wshadow -Werror
    # In a unity build every .cpp is a header to the compiler, also those with types of their own.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>
    # Many files at once are much to keep: the compiler looks for what it no longer needs a tenth of
    # its time, unless it may have 1 GB first.
    $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:--param=ggc-min-heapsize=1048576>
    # The compiler cache looks at what headers say, not at when they were written.
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>"
    # The same bits on every machine of a type: no fused multiply-add behind our back.
    -ffp-contract=off)
target_compile_definitions(crowd_options INTERFACE
    QT_NO_KEYWORDS QT_NO_CAST_FROM_ASCII QT_NO_CAST_TO_ASCII
    GLM_ENABLE_EXPERIMENTAL GLM_FORCE_SILENT_WARNINGS)
target_include_directories(crowd_options INTERFACE "${CMAKE_SOURCE_DIR}")

if(CROWD_SANITIZER)
    # What a sanitizer adds hides from gcc that a value is set on every way (an empty std::optional
    # that is returned): such a warning is the unsanitized presets' to give.
    target_compile_options(crowd_options INTERFACE
        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()

if(CROWD_SANITIZER STREQUAL "address")
    # A use of a null pointer, or of one that points beyond what it points into, is the address
    # sanitizer's too; checking the pointers themselves, and the alignment of each access, more than
    # doubles the time to compile.
    set(CROWD_CHECKS -fsanitize=address,undefined -fno-sanitize-recover=undefined
        -fno-sanitize=null,alignment,object-size,pointer-overflow)
    # The tests say CROWD_UNCHECKED: what they call is checked, and they themselves compile in two
    # thirds of the time without.
    set(is_checked $<NOT:$<BOOL:$<TARGET_PROPERTY:CROWD_UNCHECKED>>>)
    target_compile_options(crowd_options INTERFACE
        -fno-omit-frame-pointer "$<${is_checked}:${CROWD_CHECKS}>")
    target_link_options(crowd_options INTERFACE -fsanitize=address,undefined)
elseif(CROWD_SANITIZER STREQUAL "thread")
    target_compile_options(crowd_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
    target_link_options(crowd_options INTERFACE -fsanitize=thread)
    # TBB as packaged is not instrumented; parallelFor falls back to threads of our own.
    target_compile_definitions(crowd_options INTERFACE CROWD_PARALLEL_STD_THREADS)
elseif(CROWD_SANITIZER)
    message(FATAL_ERROR "CROWD_SANITIZER is '${CROWD_SANITIZER}': use 'address', 'thread' or leave it empty")
endif()
