# Makes the compressed man page of a tool from what its -h says.
# usage: cmake -D TOOL=<program> -D VERSION=<version> -D HELP2MAN=<program> -D GZIP=<program> -D PAGE=<page.1> -P man_page.cmake
execute_process(COMMAND "${TOOL}" -h OUTPUT_VARIABLE help RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${TOOL} -h: ${result}")
endif()
string(REGEX MATCH "^[^.:\n]*" summary "${help}")
string(TOLOWER "${summary}" summary)
file(REMOVE "${PAGE}.gz")
execute_process(COMMAND "${HELP2MAN}" --no-info "--version-string=${VERSION}" "--name=${summary}"
  "--source=pcl_normal_smoothing ${VERSION}" "--output=${PAGE}" "${TOOL}" RESULT_VARIABLE result)
if(result EQUAL 0)
  execute_process(COMMAND "${GZIP}" -9n "${PAGE}" RESULT_VARIABLE result)
endif()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "no man page for ${TOOL}: ${result}")
endif()
