# The headers as users see them: without our precompiled header, and most without a compiled library.

# A program that has all of the package from its headers: the guest builds and runs it. Here it is what
# the linter reads.
add_library(header_only OBJECT EXCLUDE_FROM_ALL headers/header_only.cpp)
target_link_libraries(header_only PRIVATE development_header_only)

# Every header compiles alone, and twice. An object is the stamp that says so; of a header nothing is
# emitted. The stages behind the public functions are left out there, or they would be compiled once
# for each of these, and are headers of their own.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include"
     "${PROJECT_SOURCE_DIR}/include/*.h")
# Those behind the public ones take minutes, so only where everything is tested.
if(NOT Point_set_skeletonization_3_COMPARISON)
  list(FILTER headers EXCLUDE REGEX "internal/")
endif()
set(header_sources "")
foreach(header IN LISTS headers)
  set(header_source "${CMAKE_CURRENT_BINARY_DIR}/headers/${header}.cpp")
  file(CONFIGURE OUTPUT "${header_source}" CONTENT "#include <@header@>\n#include <@header@>\n"
       @ONLY)
  list(APPEND header_sources "${header_source}")
endforeach()
add_library(headers_compile_alone OBJECT EXCLUDE_FROM_ALL ${header_sources})
target_link_libraries(headers_compile_alone PRIVATE development_header_only)
target_compile_definitions(headers_compile_alone
                           PRIVATE CGAL_POINT_SET_SKELETONIZATION_3_COMPILED)
target_compile_options(headers_compile_alone PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-O0>)
add_test(NAME headers_compile_alone
         COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --parallel 2 --target
                 headers_compile_alone)

# Calls that must not compile, and what a compiler says then.
add_library(wrong_calls OBJECT EXCLUDE_FROM_ALL headers/wrong_calls.cpp)
target_link_libraries(wrong_calls PRIVATE development_header_only)
target_compile_definitions(wrong_calls PRIVATE CGAL_POINT_SET_SKELETONIZATION_3_COMPILED)
add_test(NAME wrong_calls
         COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/headers/wrong_calls.sh" "${CMAKE_COMMAND}"
                 "${PROJECT_BINARY_DIR}")

# Both build in our own folder.
set_tests_properties(headers_compile_alone wrong_calls PROPERTIES RESOURCE_LOCK build_folder)

add_test(NAME license COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/headers/license.sh"
                              "${CMAKE_CXX_COMPILER}")
