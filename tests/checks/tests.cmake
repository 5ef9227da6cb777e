# The static checks themselves. Nothing that is compiled.
foreach(check compile_alone function_lengths hook)
    add_test(NAME checks_${check}
        COMMAND ${Python3_EXECUTABLE} -B "${CMAKE_CURRENT_SOURCE_DIR}/checks/check_${check}.py")
    set_tests_properties(checks_${check} PROPERTIES LABELS checks)
endforeach()
