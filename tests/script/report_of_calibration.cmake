# grit report of what grit calibrate leaves: its parameters with their intervals, its own page as a link beside it and in it,
# command and version; a TOML and a page that are none of calibrate are nothing.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${GRIT} calibrate ${SOURCE}/verification/calibration/oedometer.toml --samples 0 --quiet --out ${WORK}/own
                COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${WORK}/own/mine_sand.toml "[sand]\nname = \"lausitz\"\n")
file(WRITE ${WORK}/own/mine_report.html "<p>another page</p>")
execute_process(COMMAND ${GRIT} report ${WORK}/own COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(COMMAND ${GRIT} report ${WORK}/own --out "${WORK}/page.html" COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
file(STRINGS ${WORK}/own/oedometer_sand.toml bounds REGEX "^#   n ")
string(REGEX MATCH "n ([0-9.]+) \\.\\.\\. ([0-9.]+)" all "${bounds}")
set(row "<td>n</td><td>-</td><td>[0-9.]+</td><td>${CMAKE_MATCH_1}</td><td>${CMAKE_MATCH_2}</td><td></td></tr>")
file(READ ${WORK}/own/index.html page)
foreach(part "${row}" "<td>critical_friction_angle</td><td>phi_c</td><td>deg</td><td>33.1</td><td></td>"
             "<h3>Karlsruhe fine sand, one oedometer test</h3>" "href=\"oedometer_report.html\"" "<iframe sandbox title="
             "tests fitted: OE1" "<td>oedometer_sand.toml</td><td>grit calibrate oedometer.toml</td><td>Grit [0-9.]+")
  if(NOT page MATCHES "${part}")
    message(FATAL_ERROR "the page has no ${part}")
  endif()
endforeach()
if(page MATCHES "mine_|another page")
  message(FATAL_ERROR "the page shows what grit calibrate did not write")
endif()
file(READ ${WORK}/page.html page)
if(NOT page MATCHES "href=\"own/oedometer_report.html\"")
  message(FATAL_ERROR "a page elsewhere has no way to that of grit calibrate")
endif()
