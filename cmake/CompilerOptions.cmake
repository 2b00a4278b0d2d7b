# How this project's own targets are compiled.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)

find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE})
endif()

function(pcl_normal_smoothing_compile_options target)
  target_compile_options(${target} PRIVATE
    -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
    # Of clang, where a test uses GoogleTest's macros as their documentation does.
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-gnu-zero-variadic-macro-arguments>
    # And where a point type is made of PCL's macros.
    $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-gnu-anonymous-struct;-Wno-nested-anon-types>
    # One result on every machine: no fused multiply-add, whatever the instruction set.
    -ffp-contract=off
    $<$<BOOL:${WARNINGS_AS_ERRORS}>:-Werror>)
endfunction()
