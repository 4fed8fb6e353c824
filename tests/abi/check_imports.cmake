cmake_minimum_required(VERSION 3.25)
# LIBRARY asks of others only what ALLOWED lists: nothing that prints, ends a process, starts a thread,
# allocates or reads the environment; and it links to the C library alone.
execute_process(COMMAND ${NM} -D --undefined-only --format=posix ${LIBRARY}
                OUTPUT_VARIABLE symbols COMMAND_ERROR_IS_FATAL ANY)
string(REGEX REPLACE "[@ ][^\n]*" "" symbols "${symbols}")
string(REPLACE "\n" ";" symbols "${symbols}")
file(STRINGS ${ALLOWED} allowed REGEX "^[^#]")
foreach(symbol IN LISTS symbols)
  if(symbol AND NOT symbol IN_LIST allowed)
    message(SEND_ERROR "${LIBRARY} needs ${symbol}, which ${ALLOWED} does not list")
  endif()
endforeach()

execute_process(COMMAND ${OBJDUMP} -p ${LIBRARY} OUTPUT_VARIABLE header COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "NEEDED +[^\n]+" needed "${header}")
foreach(library IN LISTS needed)
  if(NOT library MATCHES "NEEDED +(libc|libm)\\.so")
    message(SEND_ERROR "${LIBRARY} links to ${library}")
  endif()
endforeach()
