# The Debian packages that cpack makes: library, -dev and tools. scripts/package.sh configures for them.
set(soversion ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
set(library_package libpcl-normal-smoothing${soversion})
set(development_package libpcl-normal-smoothing-dev)
set(tools_package pcl-normal-smoothing-tools)

string(REGEX MATCH "<maintainer email=\"([^\"]+)\">([^<]+)<" _ "${package_xml}")
set(CPACK_DEBIAN_PACKAGE_MAINTAINER "${CMAKE_MATCH_2} <${CMAKE_MATCH_1}>")
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME pcl-normal-smoothing)
set(CPACK_PACKAGE_VENDOR ${PROJECT_NAME})
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL library development)
if(BUILD_TOOLS)
  list(APPEND CPACK_COMPONENTS_ALL tools)
endif()
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/src)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)

set(about "This plugin module for the Point Cloud Library estimates normals, filters them
and moves the points to fit them, after Valdivia et al. (SIBGRAPI 2013), or
smooths in robust rounds by the noise that it finds. Every field of a cloud
but the positions is kept.

")
set(this_version "(= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")

# debian_package(component package section summary contents)
macro(debian_package component package section summary contents)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${package})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${about}${contents}")
  install(FILES ${PROJECT_BINARY_DIR}/debian/copyright ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endmacro()

debian_package(library ${library_package} libs "edge-preserving smoothing of point clouds (library)"
  "This package has the shared library.")
debian_package(development ${development_package} libdevel "edge-preserving smoothing of point clouds (development)"
  "This package has what it takes to build programs with the library.")
debian_package(tools ${tools_package} science "edge-preserving smoothing of point clouds (tools)"
  "This package has the command-line tools, for PCD and PLY files.")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/cmake/triggers)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${library_package} ${this_version}, libpcl-dev (>= 1.12)")
set(CPACK_DEBIAN_TOOLS_PACKAGE_DEPENDS "${library_package} ${this_version}")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "xvfb") # for pictures of the viewer without a display

# What Debian wants beside the files: CPack makes neither.
string(TIMESTAMP changelog_date "%a, %d %b %Y %H:%M:%S +0000" UTC) # that of SOURCE_DATE_EPOCH where it is set
file(READ LICENSE license_text)
string(REGEX MATCH "Copyright \\(c\\) ([^\n]+)" _ "${license_text}")
set(copyright_line "${CMAKE_MATCH_1}")
string(REGEX REPLACE "^.*Copyright[^\n]*\n\n" "" license_text "${license_text}")
string(REGEX REPLACE "\n+$" "" license_text "${license_text}")
string(REPLACE "\n\n" "\n.\n" license_text "${license_text}")
string(REPLACE "\n" "\n " license_text " ${license_text}")
configure_file(cmake/copyright.in debian/copyright @ONLY)
configure_file(cmake/changelog.debian.in debian/changelog.Debian @ONLY)
file(ARCHIVE_CREATE OUTPUT ${PROJECT_BINARY_DIR}/debian/changelog.Debian.gz
  PATHS ${PROJECT_BINARY_DIR}/debian/changelog.Debian FORMAT raw COMPRESSION GZip COMPRESSION_LEVEL 9)
include(CPack)
