# Installs the library, and the package that find_package(pcl_normal_smoothing) and pkg-config find; the tools install
# themselves. The components are those of find_package and of the Debian packages: library, development, tools.
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_normal_smoothing)

install(TARGETS pcl_normal_smoothing EXPORT pcl_normal_smoothingTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library)
install(DIRECTORY include/pcl_normal_smoothing DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
  FILES_MATCHING PATTERN "*.h" PATTERN "*.hpp")
install(EXPORT pcl_normal_smoothingTargets NAMESPACE pcl_normal_smoothing:: DESTINATION ${package_dir}
  COMPONENT development)
if(BUILD_TOOLS)
  install(EXPORT pcl_normal_smoothingToolTargets NAMESPACE pcl_normal_smoothing:: DESTINATION ${package_dir}
    COMPONENT tools)
endif()

configure_package_config_file(cmake/pcl_normal_smoothingConfig.cmake.in pcl_normal_smoothingConfig.cmake
  INSTALL_DESTINATION ${package_dir} NO_SET_AND_CHECK_MACRO)
write_basic_package_version_file(pcl_normal_smoothingConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_normal_smoothingConfig.cmake
  ${CMAKE_CURRENT_BINARY_DIR}/pcl_normal_smoothingConfigVersion.cmake
  DESTINATION ${package_dir} COMPONENT development)

file(RELATIVE_PATH prefix_from_pkgconfig ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
foreach(dir libdir includedir)
  string(TOUPPER CMAKE_INSTALL_${dir} installed)
  if(IS_ABSOLUTE "${${installed}}")
    set(${dir}_of_pkgconfig "${${installed}}")
  else()
    set(${dir}_of_pkgconfig "\${prefix}/${${installed}}")
  endif()
endforeach()
configure_file(cmake/pcl_normal_smoothing.pc.in pcl_normal_smoothing.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pcl_normal_smoothing.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
  COMPONENT development)

install(FILES LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT documentation)
# ROS looks for the manifest there.
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_normal_smoothing COMPONENT development)
