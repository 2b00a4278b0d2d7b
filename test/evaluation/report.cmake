# The study's report. Debian's Python, which Debian's matplotlib and VTK belong to.
find_program(REPORT_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(REPORT_PYTHON python3)
if(REPORT_PYTHON)
  add_test(NAME test_report
    COMMAND ${REPORT_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/test_report.py ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/tools
      $<TARGET_FILE:pcl_smoothing_study>)
  set_tests_properties(test_report PROPERTIES SKIP_RETURN_CODE 77)
  add_test(NAME test_small_study
    COMMAND bash ${CMAKE_CURRENT_LIST_DIR}/small_study.sh ${PROJECT_SOURCE_DIR}/evaluation/study.sh ${PROJECT_BINARY_DIR}
      ${CMAKE_CURRENT_BINARY_DIR}/small_study)
  set_tests_properties(test_report test_small_study PROPERTIES TIMEOUT 600)
  set_test_environment(test_report test_small_study)
endif()
