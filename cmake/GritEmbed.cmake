# cmake -DOUTPUT=FILE.cpp -DHEADER=cli/report/embedded.hpp -DTEXTS=name=path,name=path -P GritEmbed.cmake: functions of that
# header that return texts; an empty path is an empty text.
set(out "// Made by cmake/GritEmbed.cmake.\n#include \"${HEADER}\"\n\nnamespace cli {\n")
string(REPLACE "," ";" texts "${TEXTS}")
foreach(each IN LISTS texts)
  string(REGEX MATCH "^([^=]+)=(.*)$" all "${each}")
  set(name ${CMAKE_MATCH_1})
  set(text "")
  if(CMAKE_MATCH_2)
    file(READ ${CMAKE_MATCH_2} text)
  endif()
  string(APPEND out "\nconst std::string& ${name}() {\n    static const std::string text = R\"GRIT(${text})GRIT\";\n    return text;\n}\n")
endforeach()
file(WRITE ${OUTPUT} "${out}\n}  // namespace cli\n")
