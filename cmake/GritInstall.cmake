# Installation: headers, libraries, find_package(Grit), pkg-config, what guides a user. The components are the packages
# of GritPackages.cmake.
include(CMakePackageConfigHelpers)

install(
  TARGETS grit grit_static
  EXPORT GritTargets
  LIBRARY COMPONENT library NAMELINK_COMPONENT development
  ARCHIVE COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/grit DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development)
set(GRIT_CMAKE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/Grit)
install(EXPORT GritTargets NAMESPACE Grit:: DESTINATION ${GRIT_CMAKE_DIR} COMPONENT development)
# The Fortran module is installed as source: no compiler is needed here, and each user has his own.
set(GRIT_FORTRAN_INSTALL_DIR ${CMAKE_INSTALL_DATADIR}/grit/fortran)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/adapters/fortran/ DESTINATION ${GRIT_FORTRAN_INSTALL_DIR}
        COMPONENT development FILES_MATCHING PATTERN "*.f90")
install(FILES ${CMAKE_CURRENT_LIST_DIR}/GritFortran.cmake DESTINATION ${GRIT_CMAKE_DIR} COMPONENT development)
configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/GritConfig.cmake.in GritConfig.cmake
  INSTALL_DESTINATION ${GRIT_CMAKE_DIR}
  PATH_VARS GRIT_FORTRAN_INSTALL_DIR)
write_basic_package_version_file(GritConfigVersion.cmake COMPATIBILITY ${GRIT_COMPATIBILITY})
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/GritConfig.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/GritConfigVersion.cmake DESTINATION ${GRIT_CMAKE_DIR} COMPONENT development)
# Relative to the file itself, so that the installed tree may be moved.
file(RELATIVE_PATH GRIT_PC_TO_PREFIX /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(${CMAKE_CURRENT_LIST_DIR}/grit.pc.in grit.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/grit.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT development)
# Documentation with what it names, as they lie in the tree, so that links and cases find what is beside them.
set(GRIT_DOC_DIR ${CMAKE_INSTALL_DATADIR}/doc/grit-doc)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs ${PROJECT_SOURCE_DIR}/examples DESTINATION ${GRIT_DOC_DIR} COMPONENT documentation
        PATTERN docs/site EXCLUDE PATTERN __pycache__ EXCLUDE)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/verification/cases ${PROJECT_SOURCE_DIR}/verification/data
                  ${PROJECT_SOURCE_DIR}/verification/mpm ${PROJECT_SOURCE_DIR}/verification/calibration
                  ${PROJECT_SOURCE_DIR}/verification/pile ${PROJECT_SOURCE_DIR}/verification/space
                  ${PROJECT_SOURCE_DIR}/verification/saturated
        DESTINATION ${GRIT_DOC_DIR}/verification COMPONENT documentation
        FILES_MATCHING PATTERN *.toml PATTERN *.csv PATTERN *.md PATTERN *.stl PATTERN __pycache__ EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/README.md DESTINATION ${GRIT_DOC_DIR} COMPONENT documentation)
if(TARGET grit_mgis)
  install(TARGETS grit_mgis LIBRARY DESTINATION ${GRIT_HOST_LIBDIR} COMPONENT tools)
endif()
if(TARGET grit_lammps)
  install(TARGETS grit_lammps LIBRARY DESTINATION ${GRIT_HOST_LIBDIR} COMPONENT lammps)
  install(TARGETS grit_lmp RUNTIME COMPONENT lammps)
  execute_process(COMMAND gzip -9nc ${PROJECT_SOURCE_DIR}/adapters/lammps/grit-lmp.1
                  OUTPUT_FILE ${CMAKE_CURRENT_BINARY_DIR}/grit-lmp.1.gz COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${CMAKE_CURRENT_BINARY_DIR}/grit-lmp.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT lammps)
endif()
if(TARGET grit_python AND GRIT_PYTHON_INSTALL_DIR)
  install(TARGETS grit_python LIBRARY DESTINATION ${GRIT_PYTHON_INSTALL_DIR}/grit COMPONENT python)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/adapters/python/grit DESTINATION ${GRIT_PYTHON_INSTALL_DIR}
          COMPONENT python PATTERN __pycache__ EXCLUDE)
endif()
if(TARGET grit_cli)
  install(TARGETS grit_cli COMPONENT tools)
  # The program prints its own manual page and completions: names as each reader looks for them.
  set(guide ${CMAKE_CURRENT_BINARY_DIR}/guide)
  add_custom_command(
    OUTPUT ${guide}/grit.1.gz ${guide}/grit ${guide}/grit.fish ${guide}/_grit
    COMMAND ${CMAKE_COMMAND} -E make_directory ${guide}
    COMMAND grit_cli man > ${guide}/grit.1
    COMMAND gzip -9nf ${guide}/grit.1
    COMMAND grit_cli completion bash > ${guide}/grit
    COMMAND grit_cli completion fish > ${guide}/grit.fish
    COMMAND grit_cli completion zsh > ${guide}/_grit
    DEPENDS grit_cli
    VERBATIM)
  add_custom_target(grit_guide ALL DEPENDS ${guide}/grit.1.gz)
  install(FILES ${guide}/grit.1.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT tools)
  install(FILES ${guide}/grit DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT tools)
  install(FILES ${guide}/grit.fish DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d COMPONENT tools)
  install(FILES ${guide}/_grit DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT tools)
endif()
