cmake_minimum_required(VERSION 3.25)
# Install BUILD under WORK, build the examples as a project of their own against it, and run them: the
# same loop over points prints the same numbers in C and in Fortran, the triaxial test of the Fortran
# host ends where verification/cases/lausitz_dense.toml does, and contact in space is that in the plane, by metre of width, and
# obeys Coulomb.
include(${CMAKE_CURRENT_LIST_DIR}/../run.cmake)

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix --config "${CONFIG}")
file(COPY ${SOURCE}/ DESTINATION ${WORK}/outside)
run(${CMAKE_COMMAND} -G ${GENERATOR} -S ${WORK}/outside -B ${WORK}/build
    -DCMAKE_C_COMPILER=${CC} -DCMAKE_CXX_COMPILER=${CXX} -DCMAKE_PREFIX_PATH=${WORK}/prefix)
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

# A plate that slides between grid lines meets by metre of width what it meets along one.
run(${WORK}/build/contact_step)
string(REGEX MATCH "force on the ground ([^ ]+ [^ ]+) N/m" plane "${output}")
set(plane ${CMAKE_MATCH_1})
string(REGEX MATCH "node  5 [^\n]*" node "${output}")
string(REGEX MATCH "f_p [0-9.]+" factor "${node}")
run(${WORK}/build/contact_in_space)
string(REGEX MATCH "per metre of width ([^ ]+ [^ ]+) N/m" space "${output}")
if(NOT plane OR NOT "${CMAKE_MATCH_1}" STREQUAL plane OR NOT factor OR NOT output MATCHES "node 21[^\n]*${factor}")
  message(FATAL_ERROR "contact_step: ${plane} N/m, ${factor}; contact_in_space printed\n${output}")
endif()

# Within 0.2 % of Coulomb's law, straight downhill; the weight within 0.01 N.
run(${WORK}/build/block_on_a_slope)
string(REGEX MATCH "after 0.30 s: 0\\.([0-9]+) m/s downhill, by Coulomb's law 0\\.([0-9]+); across the slope ([^\n]+)" found "${output}")
math(EXPR difference "${CMAKE_MATCH_1} - ${CMAKE_MATCH_2}")
if(NOT found OR difference LESS -12 OR difference GREATER 12 OR NOT CMAKE_MATCH_3 MATCHES "e-1[0-9]$"
   OR NOT output MATCHES "ground 309\\.9[23] N, the weight across it 309\\.93 N")
  message(FATAL_ERROR "block_on_a_slope printed\n${output}")
endif()

# The reference of that case: -398.912 kPa and e = 0.612734, within 5e-5 and 5e-6.
run(${WORK}/build/triaxial_fortran)
if(NOT output MATCHES "-0\\.200  stress 11 -398\\.9[0-2][0-9]+ kPa  void ratio 0\\.61273")
  message(FATAL_ERROR "triaxial_fortran printed\n${output}")
endif()
