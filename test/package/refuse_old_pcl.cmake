# Configures SOURCE where there is a PCL 1.11 alone: that must fail, and say what is needed.
file(REMOVE_RECURSE "${WORK}")
file(WRITE "${WORK}/pcl/PCLConfig.cmake" "set(PCL_FOUND TRUE)\n")
file(WRITE "${WORK}/pcl/PCLConfigVersion.cmake" "set(PACKAGE_VERSION 1.11.1)
if(NOT PACKAGE_FIND_VERSION VERSION_GREATER PACKAGE_VERSION)
  set(PACKAGE_VERSION_COMPATIBLE TRUE)
endif()
")
execute_process(COMMAND "${CMAKE_COMMAND}" -S "${SOURCE}" -B "${WORK}/build" -G "${GENERATOR}" "-DCMAKE_MAKE_PROGRAM=${MAKE_PROGRAM}"
  "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${COMPILER}"
  "-DPCL_DIR=${WORK}/pcl" -DCMAKE_FIND_USE_CMAKE_SYSTEM_PATH=OFF -DCMAKE_FIND_USE_SYSTEM_ENVIRONMENT_PATH=OFF
  RESULT_VARIABLE result ERROR_VARIABLE said OUTPUT_QUIET)
if(result EQUAL 0)
  message(FATAL_ERROR "PCL 1.11.1 was taken")
endif()
if(NOT said MATCHES "1\\.12" OR NOT said MATCHES "1\\.11\\.1")
  message(FATAL_ERROR "PCL 1.11.1 was refused, but not by its version: ${said}")
endif()
