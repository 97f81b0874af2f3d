# The manual page of the program, made from what it says by --help.
find_program(HELP2MAN help2man)
if(NOT HELP2MAN)
  message(STATUS "Without the manual page of skeletonize_point_set: there is no help2man.")
  return()
endif()
set(man_page "${CMAKE_CURRENT_BINARY_DIR}/skeletonize_point_set.1")
add_custom_command(
  OUTPUT "${man_page}"
  COMMAND "${HELP2MAN}" --no-info --name "curve skeletons of raw point clouds" --output "${man_page}"
          $<TARGET_FILE:skeletonize_point_set>
  DEPENDS skeletonize_point_set
  VERBATIM)
add_custom_target(man_page ALL DEPENDS "${man_page}")
if(Point_set_skeletonization_3_INSTALL)
  include(GNUInstallDirs)
  install(FILES "${man_page}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
endif()
