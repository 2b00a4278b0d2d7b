# The peers of the study.
find_package(GTest REQUIRED)
add_executable(test_peers
  ${CMAKE_CURRENT_LIST_DIR}/peer_fixture.cpp
  ${CMAKE_CURRENT_LIST_DIR}/test_peers.cpp
  ${CMAKE_CURRENT_LIST_DIR}/test_peers_lop.cpp
  ${CMAKE_CURRENT_LIST_DIR}/test_peers_trouble.cpp)
pcl_normal_smoothing_compile_options(test_peers)
target_link_libraries(test_peers PRIVATE pcl_smoothing_peers pcl_smoothing_lop GTest::gtest_main)
add_test(NAME test_peers COMMAND test_peers)
set_tests_properties(test_peers PROPERTIES TIMEOUT 300 ENVIRONMENT "OMP_WAIT_POLICY=passive")
