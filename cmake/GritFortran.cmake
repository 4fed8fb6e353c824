# Grit::fortran: module grit, compiled by whoever uses it, because .mod files suit one compiler only.
# GRIT_FORTRAN_DIR holds the sources, Grit::grit exists and Fortran is enabled.
if(NOT TARGET Grit::fortran)
  set(sources)
  foreach(name base sand_interface contact_interface geometry_interface penalty_interface surface_interface sand_arrays
               contact_arrays geometry_arrays penalty_arrays surface_arrays)
    list(APPEND sources ${GRIT_FORTRAN_DIR}/grit_${name}.f90)
  endforeach()
  add_library(grit_fortran STATIC EXCLUDE_FROM_ALL ${sources} ${GRIT_FORTRAN_DIR}/grit.f90)
  set_target_properties(
    grit_fortran PROPERTIES POSITION_INDEPENDENT_CODE ON Fortran_MODULE_DIRECTORY
                                                         ${CMAKE_CURRENT_BINARY_DIR}/grit_modules)
  target_include_directories(grit_fortran INTERFACE ${CMAKE_CURRENT_BINARY_DIR}/grit_modules)
  target_link_libraries(grit_fortran PUBLIC Grit::grit)
  add_library(Grit::fortran ALIAS grit_fortran)
endif()
