# The study's report. Debian's Python, which Debian's matplotlib and VTK belong to.
find_program(REPORT_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
find_program(REPORT_PYTHON python3)
if(REPORT_PYTHON)
  add_test(NAME test_report
    COMMAND ${REPORT_PYTHON} ${CMAKE_CURRENT_LIST_DIR}/test_report.py ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/tools)
  set_tests_properties(test_report PROPERTIES TIMEOUT 600 SKIP_RETURN_CODE 77 ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")

  # The small study as a user runs it, from the mesh to the page.
  add_test(NAME test_small_study
    COMMAND ${PROJECT_SOURCE_DIR}/evaluation/study.sh -small -built ${PROJECT_BINARY_DIR} -out ${CMAKE_CURRENT_BINARY_DIR}/small_study)
  set_tests_properties(test_small_study PROPERTIES TIMEOUT 600 PASS_REGULAR_EXPRESSION "The report: .*/report/index.html"
    ENVIRONMENT "PYTHONDONTWRITEBYTECODE=1")
endif()
