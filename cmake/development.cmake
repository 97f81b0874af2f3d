# What our own targets, programs and tests, are built with.
find_package(TBB QUIET)
include(CGAL_TBB_support)

add_library(development INTERFACE)
target_link_libraries(
  development INTERFACE Point_set_skeletonization_3::Point_set_skeletonization_3
                        $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)
# GCC's guesses about uninitialised variables come after inlining, so that it makes them about code
# inside Boost and CGAL as if it were ours.
target_compile_options(
  development INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
                        $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
