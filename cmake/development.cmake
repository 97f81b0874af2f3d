# What our own targets, programs and tests, are built with.
find_package(TBB QUIET)
include(CGAL_TBB_support)

add_library(our_warnings INTERFACE)
# GCC's guesses about values come after inlining, so that it makes them about code inside Boost and CGAL
# as if it were ours.
target_compile_options(
  our_warnings
  INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
            $<$<BOOL:${Point_set_skeletonization_3_STRICT}>:-Werror>
            "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds;-Wno-stringop-overflow>")

# For what has to see the headers as they are without the compiled library.
add_library(development_header_only INTERFACE)
target_link_libraries(
  development_header_only INTERFACE our_warnings
                                    Point_set_skeletonization_3::Point_set_skeletonization_3
                                    $<TARGET_NAME_IF_EXISTS:CGAL::TBB_support>)

# What everything else of ours is linked to, so that it compiles fast.
add_library(development INTERFACE)
target_link_libraries(
  development
  INTERFACE development_header_only
            $<TARGET_NAME_IF_EXISTS:Point_set_skeletonization_3::Point_set_skeletonization_3_compiled>)

# Looks for the packages that only some targets need. RESULT says whether all are there; if not, the user
# is told what is left out.
macro(find_what_is_needed_for left_out result)
  set(${result} TRUE)
  foreach(package IN ITEMS ${ARGN})
    find_package(${package} QUIET)
    if(NOT ${package}_FOUND)
      set(${result} FALSE)
      message(STATUS "Without ${left_out}: there is no ${package}")
    endif()
  endforeach()
endmacro()

# Compilers of these targets take 1.2 to 1.8 GB each, of others up to 1.3: with Ninja one of them at a
# time. Not those of precompiled headers, which much waits for.
set_property(GLOBAL APPEND PROPERTY JOB_POOLS point_set_skeletonization_3_large=1)
function(compile_one_at_a_time)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES JOB_POOL_COMPILE point_set_skeletonization_3_large)
    endif()
  endforeach()
endfunction()
compile_one_at_a_time(Point_set_skeletonization_3_compiled)
