# The manual pages of the programs, made from what they say by --help.
find_program(HELP2MAN help2man)
if(NOT HELP2MAN)
  message(STATUS "Without the manual page of skeletonize_point_set: there is no help2man.")
  return()
endif()
add_custom_target(man_page ALL)
foreach(program IN LISTS programs)
  set(man_page "${CMAKE_CURRENT_BINARY_DIR}/${program}.1")
  add_custom_command(
    OUTPUT "${man_page}"
    COMMAND "${HELP2MAN}" --no-info --name "curve skeletons of raw point clouds" --output
            "${man_page}" $<TARGET_FILE:${program}>
    DEPENDS ${program}
    VERBATIM)
  add_custom_target(man_page_of_${program} DEPENDS "${man_page}")
  add_dependencies(man_page man_page_of_${program})
  if(Point_set_skeletonization_3_INSTALL)
    include(GNUInstallDirs)
    install(FILES "${man_page}" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  endif()
endforeach()
