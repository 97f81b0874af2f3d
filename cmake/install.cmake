# `cmake --install` and find_package(Point_set_skeletonization_3).
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir "${CMAKE_INSTALL_DATADIR}/cmake/Point_set_skeletonization_3")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/include/" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}")
install(TARGETS Point_set_skeletonization_3 EXPORT Point_set_skeletonization_3_targets)
install(EXPORT Point_set_skeletonization_3_targets
        NAMESPACE Point_set_skeletonization_3::
        DESTINATION "${package_dir}")
write_basic_package_version_file(
  "${PROJECT_BINARY_DIR}/Point_set_skeletonization_3ConfigVersion.cmake"
  COMPATIBILITY SameMajorVersion ARCH_INDEPENDENT)
install(FILES "${PROJECT_SOURCE_DIR}/cmake/Point_set_skeletonization_3Config.cmake"
              "${PROJECT_BINARY_DIR}/Point_set_skeletonization_3ConfigVersion.cmake"
        DESTINATION "${package_dir}")
