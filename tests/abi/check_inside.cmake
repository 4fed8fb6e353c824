# Build Grit within a stranger's project under WORK in both ways, and run it there.
cmake_minimum_required(VERSION 3.25)
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)
foreach(how add_subdirectory FetchContent)
  # Where there is ccache, with the flags of the build that has just been: all is there. Elsewhere with kernels for this
  # machine only, a third of the time to compile.
  set(ENV{CCACHE_BASEDIR} ${WORK}/${how})
  set(flags -DGRIT_NATIVE=ON)
  if("$ENV{CMAKE_CXX_COMPILER_LAUNCHER}" MATCHES ccache)
    set(flags -DCMAKE_BUILD_TYPE=${CONFIG} -DGRIT_WARNINGS_AS_ERRORS=ON)
  endif()
  run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE}/tests/abi/inside -B ${WORK}/${how} -DHOW=${how}
      -DGRIT_SOURCE=${SOURCE} ${flags} -DCMAKE_C_COMPILER=${CC} -DCMAKE_CXX_COMPILER=${CXX})
  if(output MATCHES "grit calibrate|Python")
    message(FATAL_ERROR "the library asked for more than itself:\n${output}")
  endif()
  run(${CMAKE_COMMAND} --build ${WORK}/${how} --target inside)
  run(${WORK}/${how}/inside)
endforeach()
