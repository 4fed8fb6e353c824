cmake_minimum_required(VERSION 3.25)
# The kernels of the instruction sets share no template: where two objects define a weak symbol the
# linker keeps one, and a baseline machine might run AVX code.
set(found 0)
foreach(object IN LISTS OBJECTS)
  if(NOT object MATCHES "_(baseline|avx2|avx512)\\.cpp")
    continue()
  endif()
  math(EXPR found "${found} + 1")
  execute_process(COMMAND ${NM} --format=posix ${object} OUTPUT_VARIABLE symbols
                  COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+ [VWuC] [^\n]*" weak "${symbols}")
  if(weak)
    message(SEND_ERROR "${object} defines weak symbols: ${weak}")
  endif()
endforeach()
if(found EQUAL 0)
  message(FATAL_ERROR "no kernel object among ${OBJECTS}")
endif()
