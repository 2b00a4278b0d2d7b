# The target documentation: all pages and the reference of the classes, in doc/html; a warning is an error.
find_program(DOXYGEN doxygen)
if(DOXYGEN)
  configure_file(doc/Doxyfile.in Doxyfile @ONLY)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/doc)
  add_custom_target(documentation COMMAND ${DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile VERBATIM
    COMMENT "Documentation: ${PROJECT_BINARY_DIR}/doc/html/index.html")
  if(BUILD_TESTING)
    add_test(NAME documentation COMMAND ${DOXYGEN} ${PROJECT_BINARY_DIR}/Doxyfile)
  endif()
endif()
