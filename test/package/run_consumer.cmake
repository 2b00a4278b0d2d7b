# Installs BUILD into an empty prefix below WORK, and builds and runs the project of PROJECT and PROGRAM against it.
file(REMOVE_RECURSE "${WORK}")
file(COPY "${PROJECT}" "${PROGRAM}" DESTINATION "${WORK}/consumer")

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGV}: ${result}")
  endif()
endfunction()

run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/prefix")
run("${CMAKE_COMMAND}" -S "${WORK}/consumer" -B "${WORK}/build" -G "${GENERATOR}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DCMAKE_BUILD_TYPE=${BUILD_TYPE}" "-DPCL_DIR=${PCL_DIR}"
  "-DCMAKE_CXX_COMPILER=${COMPILER}" "-DCMAKE_CXX_COMPILER_LAUNCHER=${LAUNCHER}")
run("${CMAKE_COMMAND}" --build "${WORK}/build")
run("${WORK}/build/smooth_cloud")

# The components of the package, and what it refuses.
run("${CMAKE_COMMAND}" -S "${COMPONENTS}" -B "${WORK}/components" -G "${GENERATOR}" "-DTOOLS=${TOOLS}"
  "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DPCL_DIR=${PCL_DIR}" "-DCMAKE_CXX_COMPILER=${COMPILER}")

# pkg-config tells where it is, from wherever the prefix was moved to.
find_program(PKG_CONFIG pkg-config)
file(GLOB_RECURSE pc "${WORK}/prefix/*/pcl_normal_smoothing.pc")
if(PKG_CONFIG)
  run("${PKG_CONFIG}" --validate "${pc}")
  execute_process(COMMAND "${PKG_CONFIG}" --variable=includedir "${pc}" OUTPUT_VARIABLE include_folder
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT EXISTS "${include_folder}/pcl_normal_smoothing/normal_smoothing.h")
    message(FATAL_ERROR "pkg-config names a folder without headers: ${include_folder}")
  endif()
endif()

# The installed tools find the installed library.
file(GLOB tools "${WORK}/prefix/bin/pcl_*")
foreach(tool IN LISTS tools)
  run("${tool}" -h)
endforeach()
