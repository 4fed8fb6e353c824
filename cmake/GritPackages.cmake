# Debian packages of what GritInstall.cmake installs: script/package makes and checks them. A library's package is called
# as its SONAME, so that two of them can be installed side by side.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME grit)
set(CPACK_PACKAGE_VENDOR "The Grit authors")
# Debian wants a name and an address. This address is nobody's: .example is kept free (RFC 2606). Who distributes the
# packages says his own.
set(GRIT_MAINTAINER "The Grit authors <maintainers@grit.example>" CACHE STRING "Name and address in Debian packages")
set(CPACK_PACKAGE_CONTACT "${GRIT_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "") # what is set here becomes the first line of every package
set(CPACK_COMPONENTS_ALL)

set(about "Hypoplastic sand of von Wolffersdorff with intergranular strain, and contact
of bodies at grid nodes, for finite-element and material-point codes, behind
a stable C ABI.")
set(GRIT_DEB_LIBRARY libgrit${GRIT_SOVERSION})
set(exactly "${GRIT_DEB_LIBRARY} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(debian ${CMAKE_CURRENT_BINARY_DIR}/debian)

# Date of the commit, so that the same commit makes the same packages; of an archive that of its newest file.
find_package(Git QUIET)
set(date)
if(GIT_FOUND AND EXISTS ${PROJECT_SOURCE_DIR}/.git)
  execute_process(
    COMMAND ${GIT_EXECUTABLE} log -1 "--format=%cD"
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE date
    ERROR_QUIET OUTPUT_STRIP_TRAILING_WHITESPACE)
endif()
if(NOT date)
  file(TIMESTAMP ${PROJECT_SOURCE_DIR}/CHANGELOG.md date "%a, %d %b %Y %H:%M:%S +0000" UTC)
endif()

# Paragraphs of a file as a field of Debian's copyright has them.
function(grit_paragraphs file out)
  file(READ ${file} text)
  string(REGEX REPLACE "^BSD 3-Clause License\n\n[^\n]*\n\n" "" text "${text}")
  string(REGEX REPLACE "\n\n" "\n.\n" text "${text}")
  string(STRIP "${text}" text)
  string(REPLACE "\n" "\n " text "${text}")
  set(${out} "${text}" PARENT_SCOPE)
endfunction()
grit_paragraphs(${PROJECT_SOURCE_DIR}/LICENSE licence)
grit_paragraphs(${PROJECT_SOURCE_DIR}/packages/third_party.txt third_party)

# COMPONENT becomes the package NAME; DEPENDS are beside those that its libraries have. SAME: of two architectures side by
# side (Multi-Arch: same); all of its files lie under the name of the architecture or are the same for each.
function(grit_package component name section summary)
  cmake_parse_arguments(package "SAME" "" "DEPENDS;RECOMMENDS;DETAILS;EXTRA" ${ARGN})
  string(TOUPPER ${component} key)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  set(CPACK_COMPONENTS_ALL ${CPACK_COMPONENTS_ALL} PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_NAME ${name} PARENT_SCOPE)
  # CPack knows this field from CMake 3.31 on; here it is a line below another one.
  if(package_SAME)
    string(APPEND section "\nMulti-Arch: same")
  endif()
  set(CPACK_DEBIAN_${key}_PACKAGE_SECTION "${section}" PARENT_SCOPE)
  list(JOIN package_DEPENDS ", " depends)
  set(CPACK_DEBIAN_${key}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  list(JOIN package_RECOMMENDS ", " recommends)
  set(CPACK_DEBIAN_${key}_PACKAGE_RECOMMENDS "${recommends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_DESCRIPTION "${summary}\n${about}\n\n${package_DETAILS}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${key}_PACKAGE_CONTROL_EXTRA "${package_EXTRA}" PARENT_SCOPE)
  set(GRIT_DEB_NAME ${name})
  set(GRIT_DEB_LICENCE ${licence})
  set(GRIT_DEB_THIRD_PARTY ${third_party})
  set(GRIT_DEB_DATE ${date})
  set(doc ${CMAKE_INSTALL_DATADIR}/doc/${name})
  set(copyright copyright)
  if(component STREQUAL lammps)
    set(copyright copyright_lammps)
  endif()
  configure_file(${PROJECT_SOURCE_DIR}/packages/${copyright}.in ${debian}/${name}/copyright @ONLY)
  configure_file(${PROJECT_SOURCE_DIR}/packages/changelog.in ${debian}/${name}/changelog.Debian @ONLY)
  execute_process(COMMAND gzip -9nf ${debian}/${name}/changelog.Debian COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${debian}/${name}/copyright ${debian}/${name}/changelog.Debian.gz DESTINATION ${doc}
          COMPONENT ${component} EXCLUDE_FROM_ALL)
endfunction()

# The symbols that a program may rely on: those that the tests hold the library to.
file(STRINGS ${PROJECT_SOURCE_DIR}/tests/abi/exports.txt exports REGEX "^grit_")
list(TRANSFORM exports REPLACE "(.+)" " \\1@Base ${PROJECT_VERSION}")
list(JOIN exports "\n" exports)
file(WRITE ${debian}/symbols "libgrit.so.${GRIT_SOVERSION} ${GRIT_DEB_LIBRARY} #MINVER#\n${exports}\n")
file(WRITE ${debian}/shlibs "libgrit ${GRIT_SOVERSION} ${GRIT_DEB_LIBRARY} (>= ${PROJECT_VERSION})\n")
file(WRITE ${debian}/triggers "activate-noawait ldconfig\n")

grit_package(library ${GRIT_DEB_LIBRARY} libs "hypoplastic sand and contact (library)" SAME
             DETAILS "This package has the shared library." EXTRA ${debian}/symbols ${debian}/shlibs ${debian}/triggers)
grit_package(development libgrit-dev libdevel "hypoplastic sand and contact (development files)" SAME
             DEPENDS ${exactly}
             DETAILS "This package has headers, the static library, the Fortran module as source,\nand files for CMake and pkg-config.")
grit_package(tools grit-tools science "hypoplastic sand: element tests, material points, UMAT"
             RECOMMENDS gnuplot-nox
             DETAILS "This package has the program grit, and the sand as Abaqus UMAT and VUMAT and\nas behaviour for hosts of MGIS.")
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS grit-doc)
grit_package(documentation grit-doc doc "hypoplastic sand and contact (documentation)"
             DETAILS "This package has the documentation as Markdown, programs in C, C++, Fortran and\nPython that call the library, and cases for grit.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
if(TARGET grit_python)
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  foreach(script postinst prerm)
    configure_file(${PROJECT_SOURCE_DIR}/packages/python_${script} ${debian}/python3-grit/${script} COPYONLY)
  endforeach()
  grit_package(python python3-grit python "hypoplastic sand and contact (Python module)"
               DEPENDS "python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})"
                       "python3 (<< ${Python_VERSION_MAJOR}.${next_minor})" python3-numpy
               DETAILS "This package has the module grit, which works on NumPy arrays."
               EXTRA ${debian}/python3-grit/postinst ${debian}/python3-grit/prerm)
endif()
if(TARGET grit_lammps)
  grit_package(lammps libgrit-lammps science "hypoplastic sand and contact (material points in LAMMPS)"
               DETAILS "This package has fix grit/mpm as a library that LAMMPS loads, and grit-lmp,\nwhich is LAMMPS with it.")
endif()
include(CPack)
