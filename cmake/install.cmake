# `cmake --install` and find_package(Point_set_skeletonization_3). The program installs itself, see
# examples/CMakeLists.txt.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Point_set_skeletonization_3")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(TARGETS Point_set_skeletonization_3 EXPORT Point_set_skeletonization_3_targets)
install(EXPORT Point_set_skeletonization_3_targets
        NAMESPACE Point_set_skeletonization_3::
        DESTINATION "${package_dir}")
if(Point_set_skeletonization_3_COMPILED)
  install(TARGETS Point_set_skeletonization_3_compiled
          EXPORT Point_set_skeletonization_3_compiled_targets)
  install(EXPORT Point_set_skeletonization_3_compiled_targets
          NAMESPACE Point_set_skeletonization_3::
          DESTINATION "${package_dir}")
endif()

set(compiled_with_tbb OFF)
if(Point_set_skeletonization_3_COMPILED AND TARGET CGAL::TBB_support)
  set(compiled_with_tbb ON)
endif()
configure_file("${PROJECT_SOURCE_DIR}/cmake/Point_set_skeletonization_3Config.cmake.in"
               "${PROJECT_BINARY_DIR}/Point_set_skeletonization_3Config.cmake" @ONLY)
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Point_set_skeletonization_3ConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion)
install(FILES "${PROJECT_BINARY_DIR}/Point_set_skeletonization_3Config.cmake"
              "${PROJECT_BINARY_DIR}/Point_set_skeletonization_3ConfigVersion.cmake"
        DESTINATION "${package_dir}")
