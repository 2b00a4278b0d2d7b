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

# The installed tools find the installed library.
file(GLOB tools "${WORK}/prefix/bin/pcl_*")
foreach(tool IN LISTS tools)
  run("${tool}" -h)
endforeach()
