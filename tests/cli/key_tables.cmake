# The tables of keys in DOCUMENT are those that GRIT prints.
cmake_minimum_required(VERSION 3.25)
file(READ ${DOCUMENT} text)
execute_process(COMMAND ${GRIT} mpm --keys ${KEYS} OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
string(FIND "${text}" "<!-- begin: grit mpm --keys ${KEYS} -->\n${printed}<!-- end -->" at)
if(at EQUAL -1)
  message(FATAL_ERROR "${DOCUMENT} has other tables than grit mpm --keys ${KEYS}:\n${printed}")
endif()
