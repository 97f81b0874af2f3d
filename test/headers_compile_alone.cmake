# A source file for every header that includes only that header, twice.
file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}/include"
     "${PROJECT_SOURCE_DIR}/include/*.h")
set(header_sources "")
foreach(header IN LISTS headers)
  set(header_source "${CMAKE_CURRENT_BINARY_DIR}/headers/${header}.cpp")
  file(CONFIGURE OUTPUT "${header_source}" CONTENT "#include <@header@>\n#include <@header@>\n"
       @ONLY)
  list(APPEND header_sources "${header_source}")
endforeach()

add_library(headers_compile_alone OBJECT ${header_sources})
target_link_libraries(headers_compile_alone PRIVATE development)
# Nothing of it is ever run.
target_compile_options(headers_compile_alone PRIVATE -O0)

add_test(NAME headers_compile_alone
         COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --target headers_compile_alone)
