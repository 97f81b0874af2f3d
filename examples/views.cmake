# What the programs need to write pages (three.js) and pictures (cairo); without, they refuse them.
set(JAVASCRIPT_DIR /usr/share/javascript CACHE PATH "Where JavaScript libraries are")
set(page_files page/skeleton.html page/skeleton.css page/skeleton.js)
foreach(script IN ITEMS
        three/build/three.min.js three/examples/js/controls/OrbitControls.js
        three/examples/js/lines/LineSegmentsGeometry.js three/examples/js/lines/LineMaterial.js
        three/examples/js/lines/LineSegments2.js)
  get_filename_component(name "${script}" NAME)
  find_file(PAGE_${name} "${script}" PATHS "${JAVASCRIPT_DIR}" NO_DEFAULT_PATH)
  list(APPEND page_files "${PAGE_${name}}")
endforeach()
if(page_files MATCHES NOTFOUND)
  message(STATUS "skeletonize_point_set writes no .html: there is no three.js in JAVASCRIPT_DIR "
                 "(${JAVASCRIPT_DIR}). Debian has it in libjs-three.")
else()
  set(embedded "${CMAKE_CURRENT_BINARY_DIR}/page_files.cpp")
  add_custom_command(
    OUTPUT "${embedded}"
    COMMAND "${CMAKE_COMMAND}" "-DSOURCE=${embedded}" "-DFILES=${page_files}" -P
            "${CMAKE_CURRENT_SOURCE_DIR}/embed_files.cmake"
    WORKING_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}"
    DEPENDS embed_files.cmake ${page_files}
    VERBATIM)
  add_library(pages STATIC write_page.cpp "${embedded}")
  target_include_directories(pages PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(pages PRIVATE development nlohmann_json::nlohmann_json)
  target_compile_definitions(pages INTERFACE WITH_THREE_JS)
  target_link_libraries(program PUBLIC pages)
endif()

find_path(CAIRO_INCLUDE_DIR cairo.h PATH_SUFFIXES cairo)
find_library(CAIRO_LIBRARY cairo)
if(CAIRO_INCLUDE_DIR AND CAIRO_LIBRARY)
  add_library(pictures STATIC draw_picture.cpp)
  target_include_directories(pictures PRIVATE "${CAIRO_INCLUDE_DIR}")
  target_link_libraries(pictures PRIVATE development PUBLIC "${CAIRO_LIBRARY}")
  target_compile_definitions(pictures INTERFACE WITH_CAIRO)
  target_link_libraries(program PUBLIC pictures)
else()
  message(STATUS "skeletonize_point_set writes no .png and .svg: there is no cairo. Debian has it in "
                 "libcairo2-dev.")
endif()
