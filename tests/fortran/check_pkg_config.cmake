cmake_minimum_required(VERSION 3.25)
# Install BUILD under WORK and make the triaxial host of it by hand, as docs/fortran.md says.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config "${CONFIG}")
file(GLOB_RECURSE pc ${WORK}/prefix/*/grit.pc)
get_filename_component(pc_dir "${pc}" DIRECTORY)
get_filename_component(libdir ${pc_dir} DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
set(ENV{LD_LIBRARY_PATH} ${libdir})

# The lines of the page between the fences, with its compiler and its program.
file(READ ${SOURCE}/docs/fortran.md page)
string(REGEX MATCH "```\n(dir=[^`]*)```" fenced "${page}")
string(REPLACE "gfortran" "${FC}" commands "${CMAKE_MATCH_1}")
string(REPLACE "host.f90" "${SOURCE}/examples/triaxial.f90" commands "${commands}")
file(WRITE ${WORK}/make.sh "set -e\n${commands}")
run(bash make.sh)
run(${WORK}/host)
if(NOT output MATCHES "-0\\.200  stress 11 -398\\.9[0-2][0-9]+ kPa  void ratio 0\\.61273")
  message(FATAL_ERROR "triaxial.f90 printed\n${output}")
endif()
