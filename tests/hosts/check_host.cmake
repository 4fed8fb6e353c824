cmake_minimum_required(VERSION 3.25)
# HOST (a command line) ends where REFERENCE does, by COMPARE. Files go to WORK.
file(MAKE_DIRECTORY ${WORK})
execute_process(COMMAND ${REFERENCE} OUTPUT_FILE ${WORK}/reference.txt COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${HOST} OUTPUT_FILE ${WORK}/host.txt COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${COMPARE} ${WORK}/reference.txt ${WORK}/host.txt OUTPUT_VARIABLE differences
                RESULT_VARIABLE result)
message("largest difference relative to the stress\n${differences}")
if(NOT result EQUAL 0)
  message(FATAL_ERROR "${HOST} does not end where the C ABI does")
endif()
