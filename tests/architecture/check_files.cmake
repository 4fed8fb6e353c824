# Nothing is left for later. SOURCE is the root of the tree.
cmake_minimum_required(VERSION 3.25)

# Written apart, for this file is checked too.
string(CONCAT markers "(TO" "DO|FIX" "ME|GTEST_" "SKIP|DISABLED" "_)")

set(files)
foreach(folder include support umat contact adapters element cli verification examples tests cmake script docs)
  file(GLOB_RECURSE found ${SOURCE}/${folder}/*)
  list(APPEND files ${found})
endforeach()
file(GLOB top ${SOURCE}/*.txt ${SOURCE}/*.md ${SOURCE}/*.json)
list(APPEND files ${top})
list(FILTER files EXCLUDE REGEX "/verification/(data|report)/|\\.(abi|png|svg|csv|pdf)$")

foreach(file IN LISTS files)
  file(READ ${file} text)
  if(text MATCHES "${markers}")
    message(SEND_ERROR "${file} is not finished: ${CMAKE_MATCH_0}")
  endif()
endforeach()
