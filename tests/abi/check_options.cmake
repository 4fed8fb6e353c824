cmake_minimum_required(VERSION 3.25)
# Options that ask for what other options leave out are refused by name. SOURCE: root of the tree.
function(expect_refusal asked missing)
  file(REMOVE_RECURSE ${WORK})
  execute_process(COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${WORK} -DCMAKE_C_COMPILER=${CC}
                          -DCMAKE_CXX_COMPILER=${CXX} -DGRIT_BUILD_TESTS=OFF -DGRIT_BUILD_CLI=OFF
                          -DGRIT_BUILD_FORTRAN=OFF -D${asked}=ON -D${missing}=OFF
                  RESULT_VARIABLE result OUTPUT_QUIET ERROR_VARIABLE errors)
  if(result EQUAL 0 OR NOT errors MATCHES "${asked}=ON needs ${missing}=ON")
    message(SEND_ERROR "${asked} without ${missing}: exit status ${result}\n${errors}")
  endif()
endfunction()

expect_refusal(GRIT_BUILD_LAMMPS GRIT_BUILD_MPM)
expect_refusal(GRIT_BUILD_LAMMPS GRIT_BUILD_ADAPTERS)
expect_refusal(GRIT_BUILD_PYTHON GRIT_BUILD_ADAPTERS)
