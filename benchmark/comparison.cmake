# This package beside other methods: `compare_skeletons`, its report, and `performance`.
find_what_is_needed_for("the comparison" with_comparison nlohmann_json)
if(NOT with_comparison)
  return()
endif()

# One adapter per compared method; CONFIGURE_DEPENDS, as methods come one by one.
file(GLOB sources CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" methods/*.cpp)
list(REMOVE_ITEM sources ${quality_methods})
add_library(compared_methods STATIC ${sources})
target_link_libraries(compared_methods PUBLIC measured PRIVATE with_precompiled)
target_precompile_headers(compared_methods REUSE_FROM precompiled)
compile_one_at_a_time(compared_methods)

add_subdirectory(performance)
add_subdirectory(report)

file(GLOB sources CONFIGURE_DEPENDS comparison/*.cpp)
add_library(comparison STATIC ${sources} forked.cpp)
target_link_libraries(comparison PUBLIC compared_methods PRIVATE with_precompiled
                                                                 nlohmann_json::nlohmann_json)
target_precompile_headers(comparison REUSE_FROM precompiled)
compile_one_at_a_time(comparison)

if(TARGET html_report)
  add_executable(compare_skeletons compare_skeletons.cpp)
  target_link_libraries(compare_skeletons PRIVATE comparison html_report CLI11::CLI11)
endif()
