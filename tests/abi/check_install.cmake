cmake_minimum_required(VERSION 3.25)
# Install BUILD under WORK, and let strangers use it: CMake with both libraries, and pkg-config.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

set(prefix ${WORK}/prefix)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first --config "${CONFIG}")
file(RENAME ${WORK}/first ${prefix}) # an installed tree may be moved

run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK}/consumer
    -DCMAKE_C_COMPILER=${CC} -DCMAKE_PREFIX_PATH=${prefix} -DGRIT_VERSION=${VERSION})
run(${CMAKE_COMMAND} --build ${WORK}/consumer)
run(${WORK}/consumer/with_shared)
run(${WORK}/consumer/with_static)

# A component that is not there is refused by name.
file(WRITE ${WORK}/asks/CMakeLists.txt
     "cmake_minimum_required(VERSION 3.25)\nproject(Asks LANGUAGES C)\nfind_package(Grit REQUIRED COMPONENTS pascal)\n")
execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK}/asks -B ${WORK}/asked
                        -DCMAKE_C_COMPILER=${CC} -DCMAKE_PREFIX_PATH=${prefix}
                RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
if(result EQUAL 0 OR NOT errors MATCHES "pascal")
  message(FATAL_ERROR "find_package(Grit COMPONENTS pascal) ended with ${result}:\n${errors}")
endif()
# What is installed is found from where it lies, not from where it was built.
file(GLOB_RECURSE programs ${prefix}/bin/*)
foreach(program IN LISTS programs)
  if(program MATCHES "/grit$")
    run(${program} --version)
  endif()
  run(${OBJDUMP} -p ${program})
  if(output MATCHES "R(UN)?PATH +([^\n]*)" AND NOT CMAKE_MATCH_2 MATCHES "^\\$ORIGIN")
    message(FATAL_ERROR "${program} looks for libraries in ${CMAKE_MATCH_2}")
  endif()
endforeach()

# The loader tells incompatible libraries apart by this name: before 1.0 that is another minor version.
string(REGEX REPLACE "^(0\\.[0-9]+|[0-9]+).*" "\\1" soversion ${VERSION})
file(GLOB_RECURSE library ${prefix}/*/libgrit.so)
run(${OBJDUMP} -p ${library})
if(NOT output MATCHES "SONAME +libgrit\\.so\\.([0-9.]+)" OR NOT CMAKE_MATCH_1 STREQUAL soversion)
  message(FATAL_ERROR "libgrit.so.${soversion} is called libgrit.so.${CMAKE_MATCH_1}")
endif()

file(GLOB_RECURSE pc ${prefix}/*/grit.pc)
get_filename_component(pc_dir "${pc}" DIRECTORY)
set(ENV{PKG_CONFIG_PATH} ${pc_dir})
run(${PKG_CONFIG} --cflags --libs grit)
separate_arguments(flags UNIX_COMMAND "${output}")
run(${CC} -std=c11 -o ${WORK}/with_pkg_config ${SOURCE}/consumer.c ${flags})
get_filename_component(libdir ${pc_dir} DIRECTORY)
set(ENV{LD_LIBRARY_PATH} ${libdir})
run(${WORK}/with_pkg_config)
run(${PKG_CONFIG} --static --cflags --libs grit)
separate_arguments(flags UNIX_COMMAND "${output}")
run(${CC} -std=c11 -static -o ${WORK}/with_pkg_config_static ${SOURCE}/consumer.c ${flags})
run(${WORK}/with_pkg_config_static)
