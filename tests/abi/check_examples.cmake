cmake_minimum_required(VERSION 3.25)
# Install BUILD under WORK, build the examples as a project of their own against it, and run them: the
# same loop over points prints the same numbers in C and in Fortran, and the triaxial test of the Fortran
# host ends where verification/cases/lausitz_dense.toml does.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config "${CONFIG}")
file(COPY ${SOURCE}/ DESTINATION ${WORK}/outside)
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK}/outside -B ${WORK}/build
    -DCMAKE_C_COMPILER=${CC} -DCMAKE_PREFIX_PATH=${WORK}/prefix)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/first_update)
file(READ ${SOURCE}/../docs/interface.md page)
string(FIND "${page}" "${output}" at)
if(at EQUAL -1)
  message(FATAL_ERROR "first_update printed\n${output}, docs/interface.md says otherwise")
endif()

foreach(example host_loop contact_step)
  foreach(language "" _fortran)
    run(${WORK}/build/${example}${language})
    string(REGEX REPLACE " +" " " printed${language} "${output}")
  endforeach()
  if(NOT printed STREQUAL printed_fortran)
    message(FATAL_ERROR "C printed\n${printed}, Fortran\n${printed_fortran}")
  endif()
endforeach()

# The reference of that case: -398.912 kPa and e = 0.612734, within 5e-5 and 5e-6.
run(${WORK}/build/triaxial_fortran)
if(NOT output MATCHES "-0\\.200  stress 11 -398\\.9[0-2][0-9]+ kPa  void ratio 0\\.61273")
  message(FATAL_ERROR "triaxial_fortran printed\n${output}")
endif()
