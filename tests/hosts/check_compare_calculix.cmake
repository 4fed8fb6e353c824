cmake_minimum_required(VERSION 3.25)
# COMPARE takes a .dat of two points that agree with the CSV, and refuses it with one number that is off or
# none, at either point and on either side, a stress that must vanish included. Files go to WORK.
file(MAKE_DIRECTORY ${WORK})
file(WRITE ${WORK}/deck.inp "** until 1.
** compare sxx = stress_11 within 1e-6
** compare syy = stress_12 within 1e-6 of 100
** compare sdv1 = void_ratio within 1e-6
** compare sdv2 = -void_ratio-stress_11 within 1e-6
")

function(verdict expected first second void_ratio result)
  file(WRITE ${WORK}/deck.dat "
 stresses (elem, integ.pnt.,sxx,syy,szz,sxy,sxz,syz) for set SAND and time  0.1000000E+01

         1   1 ${first}
         1   2 ${second}

 internal state variables (elem, integ.pnt.,s1,s2) for set SAND and time  0.1000000E+01

         1   1  ${void_ratio}  0.9940000E+02
         1   2  0.6000000E+00  0.9940000E+02
")
  file(WRITE ${WORK}/deck.csv "# how the run ended\nstress_11[kPa], stress_12[kPa], void_ratio\n"
                              "-1, -1, -1\n${result}\n# end\n")
  execute_process(COMMAND ${COMPARE} deck.inp deck.dat deck.csv WORKING_DIRECTORY ${WORK}
                  RESULT_VARIABLE status OUTPUT_VARIABLE printed ERROR_VARIABLE printed)
  if(NOT status EQUAL expected)
    message(SEND_ERROR "exit status ${status}, not ${expected}, of ${first}, ${second}, "
                       "${void_ratio} against ${result}\n${printed}")
  endif()
endfunction()

set(zeros "0.0E+00 0.0E+00 0.0E+00 0.0E+00")
set(good "-0.1000000E+03 0.1234567-108 ${zeros}")
set(csv "-1.000000e+02, 0, 0.6")
verdict(0 "${good}" "${good}" 0.6000001E+00 "${csv}")
foreach(wrong NaN -NaN Infinity ******* 7)
  verdict(1 "${wrong} 0.0E+00 ${zeros}" "${good}" 0.6 "${csv}")
  verdict(1 "${good}" "${wrong} 0.0E+00 ${zeros}" 0.6 "${csv}")
  verdict(1 "-0.1000000E+03 ${wrong} ${zeros}" "${good}" 0.6 "${csv}")
  verdict(1 "${good}" "-0.1000000E+03 ${wrong} ${zeros}" 0.6 "${csv}")
  verdict(1 "${good}" "${good}" ${wrong} "${csv}")
endforeach()
foreach(wrong nan -nan inf 7)
  verdict(1 "${good}" "${good}" 0.6 "${wrong}, 0, 0.6")
  verdict(1 "${good}" "${good}" 0.6 "-100, ${wrong}, 0.6")
  verdict(1 "${good}" "${good}" 0.6 "-100, 0, ${wrong}")
endforeach()
