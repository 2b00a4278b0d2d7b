# Installs the library and the package that find_package(pcl_normal_smoothing) finds; the tools install themselves.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_normal_smoothing)

install(TARGETS pcl_normal_smoothing EXPORT pcl_normal_smoothingTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/pcl_normal_smoothing DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(EXPORT pcl_normal_smoothingTargets NAMESPACE pcl_normal_smoothing:: DESTINATION ${package_dir})

configure_package_config_file(cmake/pcl_normal_smoothingConfig.cmake.in pcl_normal_smoothingConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(pcl_normal_smoothingConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_normal_smoothingConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_normal_smoothingConfigVersion.cmake
  DESTINATION ${package_dir})
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
# ROS looks for the manifest there.
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_normal_smoothing)
