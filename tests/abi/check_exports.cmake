cmake_minimum_required(VERSION 3.25)
# LIBRARY defines exactly the dynamic symbols listed in EXPECTED, in nm's order.
execute_process(COMMAND ${NM} -D --defined-only --format=posix ${LIBRARY} OUTPUT_VARIABLE symbols
                COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE " [^\n]*" "" symbols "${symbols}")
file(READ ${EXPECTED} expected)
if(NOT symbols STREQUAL expected)
  message(FATAL_ERROR "${LIBRARY} exports\n${symbols}but ${EXPECTED} lists\n${expected}")
endif()
