# The tests that run our programs, and other projects that use us.
if(TARGET skeletonize_point_set)
  set(names program_usage program_input program_robust program_output program_signals program_many
            program_moments picture recipes)
  if(TARGET pages AND TARGET pictures)
    list(APPEND names program_views)
    if(Point_set_skeletonization_3_COMPARISON)
      list(APPEND names page) # in a browser
    endif()
  endif()
  foreach(name IN LISTS names)
    add_test(NAME ${name} COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/${name}.sh"
                                  $<TARGET_FILE:skeletonize_point_set>)
  endforeach()
  if("page" IN_LIST names)
    set_tests_properties(page PROPERTIES PROCESSORS 2) # draws with all cores
  endif()
  set_tests_properties(recipes PROPERTIES ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/python")
endif()
if(TARGET skeletonize_point_set_mpi)
  add_test(NAME program_mpi
           COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/program_mpi.sh" "${MPIEXEC_EXECUTABLE}"
                   $<TARGET_FILE:skeletonize_point_set_mpi> $<TARGET_FILE:skeletonize_point_set>)
endif()
foreach(program IN ITEMS quality performance compare_skeletons)
  if(TARGET ${program})
    add_test(NAME ${program} COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/${program}.sh"
                                     $<TARGET_FILE:${program}>)
  endif()
endforeach()

# Files of skeletons, read by other programs; by VTK, which is large, only where everything is tested.
execute_process(COMMAND /usr/bin/python3 -c "import ezdxf, meshio, networkx, numpy"
                RESULT_VARIABLE no_readers OUTPUT_QUIET ERROR_QUIET)
if(no_readers)
  message(STATUS "Without the test of file formats: there is no ezdxf, meshio, networkx or numpy for "
                 "/usr/bin/python3")
else()
  add_executable(made_up_skeleton formats/made_up_skeleton.cpp)
  target_link_libraries(made_up_skeleton PRIVATE development_header_only)
  target_compile_options(made_up_skeleton PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang>:-O0>) # eight vertices
  add_test(NAME formats COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/formats.sh"
                                $<TARGET_FILE:made_up_skeleton>
                                $<$<BOOL:${Point_set_skeletonization_3_COMPARISON}>:--vtk>)
endif()

if(TARGET python_module)
  add_test(NAME python COMMAND "${Python_EXECUTABLE}"
                               "${CMAKE_CURRENT_SOURCE_DIR}/python/check_module.py")
  add_test(NAME python_example COMMAND "${Python_EXECUTABLE}"
           "${PROJECT_SOURCE_DIR}/examples/python_example.py")
  set_tests_properties(python python_example
                       PROPERTIES ENVIRONMENT "PYTHONPATH=${PROJECT_BINARY_DIR}/python;MPLBACKEND=Agg")
  # What pip installs, without pip.
  add_test(NAME python_installed
           COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/python/installed.sh" "${CMAKE_COMMAND}"
                   "${PROJECT_BINARY_DIR}" "${Python_EXECUTABLE}")
endif()

# The figures of the manual, made again somewhere else.
if(TARGET python_module AND TARGET skeletonize_point_set AND Point_set_skeletonization_3_COMPARISON
   AND EXISTS "${CGAL_DATA_DIR}/meshes/elephant.off")
  add_test(NAME figures
           COMMAND "${Python_EXECUTABLE}" "${PROJECT_SOURCE_DIR}/doc/make_figures.py"
                   "${PROJECT_BINARY_DIR}" "${CMAKE_CURRENT_BINARY_DIR}/figures")
endif()

if(TARGET html_report)
  add_executable(made_up_report report/made_up_report.cpp)
  target_include_directories(made_up_report PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(made_up_report PRIVATE html_report)
  add_test(NAME report
           COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/report.sh" $<TARGET_FILE:made_up_report>)
  set_tests_properties(report PROPERTIES PROCESSORS 2) # draws with all cores
endif()

if(TARGET doc AND Point_set_skeletonization_3_COMPARISON)
  add_test(NAME doc COMMAND "${CMAKE_COMMAND}" --build "${PROJECT_BINARY_DIR}" --target doc)
  set_tests_properties(doc PROPERTIES RESOURCE_LOCK build_folder)
endif()
# What takes long, only where everything is tested: a linter, and a run in which each access to
# memory is watched.
if(Point_set_skeletonization_3_COMPARISON)
  find_program(CLANG_TIDY clang-tidy)
  if(CLANG_TIDY AND TARGET skeletonize_point_set)
    file(GLOB readers CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/point_files/*.cpp")
    foreach(part IN ITEMS library program)
      set(files "${CMAKE_CURRENT_SOURCE_DIR}/headers/header_only.cpp")
      if(part STREQUAL program)
        set(files "${PROJECT_SOURCE_DIR}/examples/skeletonize_point_set.cpp" ${readers})
      endif()
      add_test(NAME tidy_${part} COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/tidy.sh" "${CLANG_TIDY}"
                                         "${PROJECT_BINARY_DIR}" ${files})
    endforeach()
  else()
    message(STATUS "Without the linter: there is no clang-tidy")
  endif()
  find_program(VALGRIND valgrind)
  if(VALGRIND AND TARGET simple_example AND EXISTS "${CGAL_DATA_DIR}/meshes/elephant.off")
    add_test(NAME memcheck COMMAND "${VALGRIND}" --quiet --error-exitcode=1 --leak-check=full
                                   $<TARGET_FILE:simple_example>)
  else()
    message(STATUS "Without memcheck: there is no valgrind or no sample model")
  endif()
endif()
add_test(NAME readme COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/readme.sh")
set(projects guest missing_packages)
if(Point_set_skeletonization_3_INSTALL AND Point_set_skeletonization_3_COMPILED)
  list(APPEND projects find_package)
endif()
foreach(name IN LISTS projects)
  add_test(NAME ${name}
           COMMAND sh "${CMAKE_CURRENT_SOURCE_DIR}/${name}/run.sh" "${PROJECT_BINARY_DIR}"
                   "${CMAKE_COMMAND}" "${CMAKE_GENERATOR}" "${CMAKE_CXX_COMPILER}")
endforeach()
