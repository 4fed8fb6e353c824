# Build Grit within a stranger's project under WORK in both ways, and run it there.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)
foreach(how add_subdirectory FetchContent)
  set(ENV{CCACHE_BASEDIR} ${WORK}/${how}) # where there is ccache, the second takes from the first
  # Kernels for this machine only: a third of the time to compile.
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/tests/abi/inside -B ${WORK}/${how} -DHOW=${how}
      -DGRIT_SOURCE=${SOURCE} -DGRIT_NATIVE=ON -DCMAKE_C_COMPILER=${CC} -DCMAKE_CXX_COMPILER=${CXX})
  if(output MATCHES "grit calibrate|Python")
    message(FATAL_ERROR "the library asked for more than itself:\n${output}")
  endif()
  run(${CMAKE_COMMAND} --build ${WORK}/${how} --target inside)
  run(${WORK}/${how}/inside)
endforeach()
