# The last row of an oedometer and of a triaxial test, computed by Grit's own sand and through the UMAT
# library: stresses and void ratio equal to 1e-8 of their size.
cmake_minimum_required(VERSION 3.25)
function(last_row file result)
  file(STRINGS ${file} rows)
  list(GET rows -1 row)
  string(REPLACE "," ";" row "${row}")
  # p, q, void_ratio are cells 7, 8 and 11.
  list(GET row 7 p)
  list(GET row 8 q)
  list(GET row 11 e)
  set(${result} "${p};${q};${e}" PARENT_SCOPE)
endfunction()
# Digits of a decimal number without its point, cut after 8 places: enough to compare as text.
foreach(case oedometer triaxial undrained)
  execute_process(COMMAND ${GRIT} element --no-plot --quiet --out ${OUT}/own ${CASES}/umat_${case}.toml
                          COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${GRIT} element --no-plot --quiet --out ${OUT}/umat --umat ${UMAT}
                          ${CASES}/umat_${case}.toml COMMAND_ERROR_IS_FATAL ANY)
  last_row(${OUT}/own/umat_${case}.csv own)
  last_row(${OUT}/umat/umat_${case}.csv through)
  foreach(a b IN ZIP_LISTS own through)
    string(SUBSTRING "${a}" 0 10 a10)
    string(SUBSTRING "${b}" 0 10 b10)
    if(NOT a10 STREQUAL b10)
      message(SEND_ERROR "${case}: ${a} of Grit's sand, ${b} through the UMAT")
    endif()
  endforeach()
  message(NOTICE "${case}: ${own} = ${through}")
endforeach()
