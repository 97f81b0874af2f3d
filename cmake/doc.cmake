# The target `doc`: the manual as HTML. A warning of Doxygen fails it.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()
configure_file("${PROJECT_SOURCE_DIR}/doc/Doxyfile.in" "${PROJECT_BINARY_DIR}/Doxyfile" @ONLY)
add_custom_target(
  doc
  # Pictures of an earlier run would be found beside those of the source.
  COMMAND "${CMAKE_COMMAND}" -E rm -rf "${PROJECT_BINARY_DIR}/doc"
  COMMAND "${CMAKE_COMMAND}" -E make_directory "${PROJECT_BINARY_DIR}/doc"
  COMMAND "${DOXYGEN_EXECUTABLE}" "${PROJECT_BINARY_DIR}/Doxyfile"
  COMMAND "${CMAKE_COMMAND}" -E cat "${PROJECT_BINARY_DIR}/doc/warnings.txt"
  COMMAND "${CMAKE_COMMAND}" -E compare_files "${PROJECT_BINARY_DIR}/doc/warnings.txt" /dev/null
  VERBATIM)
