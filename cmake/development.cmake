# What our own targets, programs and tests, are built with.
find_package(TBB QUIET)
include(CGAL_TBB_support)
include(CGAL_Eigen3_support)

add_library(our_warnings INTERFACE)
# GCC's guesses about values come after inlining, so that it makes them about code inside Boost and CGAL
# as if it were ours.
target_compile_options(
  our_warnings
  INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
            $<$<BOOL:${Point_set_skeletonization_3_STRICT}>:-Werror>
            "$<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized;-Wno-array-bounds;-Wno-stringop-overflow>")

if(TARGET Point_set_skeletonization_3_compiled)
  target_compile_options(Point_set_skeletonization_3_compiled
                         PRIVATE $<TARGET_PROPERTY:our_warnings,INTERFACE_COMPILE_OPTIONS>)
endif()

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

# A header precompiled once for the examples and the benchmark. A compiler takes it only with the macros
# that it was made with, so all of them have the sample models' folder and Eigen as CGAL uses it.
add_library(with_precompiled INTERFACE)
target_link_libraries(with_precompiled INTERFACE development CGAL::Data CGAL::Eigen3_support)
add_library(precompiled OBJECT EXCLUDE_FROM_ALL "${PROJECT_SOURCE_DIR}/cmake/precompiled.cpp")
target_link_libraries(precompiled PRIVATE with_precompiled)
target_precompile_headers(precompiled PRIVATE "${PROJECT_SOURCE_DIR}/cmake/precompiled.h")

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

# The sources of these targets include much the same, which is what takes time: four of them are
# compiled as one, in their order. Where two of them have the same name for something of their own, each
# has it in a namespace. All at once would take more memory than anything else.
function(compile_four_as_one)
  set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 4)
endfunction()

# Compilers of these targets take up to 1.9 GB each, of others up to 1.4: with Ninja one of them at a
# time. Not those of precompiled headers, which much waits for. These targets together take half of the
# time: each more of them, and a core is idle in the end.
set_property(GLOBAL APPEND PROPERTY JOB_POOLS point_set_skeletonization_3_large=1)
function(compile_one_at_a_time)
  foreach(target IN LISTS ARGN)
    if(TARGET ${target})
      set_target_properties(${target} PROPERTIES JOB_POOL_COMPILE point_set_skeletonization_3_large)
    endif()
  endforeach()
endfunction()
compile_one_at_a_time(Point_set_skeletonization_3_compiled)
