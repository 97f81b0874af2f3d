# The library compiled once, for programs that want to compile fast: the macro tells the headers that
# the functions come from here. With TBB if there is TBB; who links it gets that as well.
find_package(TBB QUIET)
include(CGAL_TBB_support)

add_library(Point_set_skeletonization_3_compiled
            "${PROJECT_SOURCE_DIR}/cmake/Point_set_skeletonization_3_compiled.cpp")
add_library(Point_set_skeletonization_3::Point_set_skeletonization_3_compiled
            ALIAS Point_set_skeletonization_3_compiled)
# For shared libraries, such as a Python module, too.
set_target_properties(Point_set_skeletonization_3_compiled PROPERTIES POSITION_INDEPENDENT_CODE ON)
target_compile_definitions(Point_set_skeletonization_3_compiled
                           PUBLIC CGAL_POINT_SET_SKELETONIZATION_3_COMPILED)
target_link_libraries(Point_set_skeletonization_3_compiled PUBLIC Point_set_skeletonization_3)
if(TARGET CGAL::TBB_support)
  target_link_libraries(Point_set_skeletonization_3_compiled PUBLIC CGAL::TBB_support)
endif()
if(NOT Point_set_skeletonization_3_INSTALL)
  # Compiled only for who links it.
  set_target_properties(Point_set_skeletonization_3_compiled PROPERTIES EXCLUDE_FROM_ALL ON)
endif()
