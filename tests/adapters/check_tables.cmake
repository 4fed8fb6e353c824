# The tables in FILE are what TABLES (grit_umat_tables) makes of them.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND ${TABLES} ${FILE} OUTPUT_VARIABLE made RESULT_VARIABLE result)
file(READ ${FILE} written)
if(NOT result EQUAL 0 OR NOT made STREQUAL written)
  message(FATAL_ERROR "${FILE}: its tables differ from adapters/abaqus/tables/rows.cpp; write them anew "
                      "with grit_umat_tables ${FILE}")
endif()
