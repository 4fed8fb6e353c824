# Installation: headers, libraries, find_package(Grit), pkg-config.
include(CMakePackageConfigHelpers)

install(TARGETS grit grit_static EXPORT GritTargets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/grit DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
set(GRIT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Grit)
install(EXPORT GritTargets NAMESPACE Grit:: DESTINATION ${GRIT_CMAKE_DIR})
# The Fortran module is installed as source: no compiler is needed here, and each user has his own.
set(GRIT_FORTRAN_INSTALL_DIR ${CMAKE_INSTALL_DATADIR}/grit/fortran)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/adapters/fortran/ DESTINATION ${GRIT_FORTRAN_INSTALL_DIR}
        FILES_MATCHING PATTERN "*.f90")
install(FILES ${CMAKE_CURRENT_LIST_DIR}/GritFortran.cmake DESTINATION ${GRIT_CMAKE_DIR})
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/GritConfig.cmake.in GritConfig.cmake
  INSTALL_DESTINATION ${GRIT_CMAKE_DIR}
  PATH_VARS GRIT_FORTRAN_INSTALL_DIR)
write_basic_package_version_file(GritConfigVersion.cmake COMPATIBILITY ${GRIT_COMPATIBILITY})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/GritConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/GritConfigVersion.cmake DESTINATION ${GRIT_CMAKE_DIR})
# Relative to the file itself, so that the installed tree may be moved.
file(RELATIVE_PATH GRIT_PC_TO_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/grit.pc.in grit.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/grit.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
if(TARGET grit_mgis)
  install(TARGETS grit_mgis LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
if(TARGET grit_lammps)
  install(TARGETS grit_lammps grit_lmp LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
endif()
if(TARGET grit_cli)
  install(TARGETS grit_cli)
endif()
