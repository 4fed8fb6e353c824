# abidiff against the interface as it was last released (or last agreed on): grit-0.1.abi.
#
# abidw reads debug information. Types and signatures of a C ABI are what its headers say, so a library
# is made of the headers alone: every declaration with an empty body, in C, without a trace of what
# compiler or standard library built Grit. That libgrit.so defines these symbols is another test.
find_program(GRIT_ABIDW NAMES abidw)
find_program(GRIT_ABIDIFF NAMES abidiff)
if(NOT GRIT_ABIDW OR NOT GRIT_ABIDIFF)
  return()
endif()

set(described "#include <grit/grit.h>\n")
foreach(header IN LISTS headers)
  set(header ${PROJECT_SOURCE_DIR}/include/${header})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${header})
  file(READ ${header} text)
  string(REGEX MATCHALL "\nGRIT_API[^;#]*\\)" declarations "${text}")
  foreach(declaration IN LISTS declarations)
    string(APPEND described "${declaration} { return 0; }\n")
  endforeach()
endforeach()
file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/described.c CONTENT "${described}" @ONLY)
add_library(grit_described SHARED ${CMAKE_CURRENT_BINARY_DIR}/described.c)
target_include_directories(grit_described PRIVATE ${PROJECT_SOURCE_DIR}/include)
target_compile_options(
  grit_described PRIVATE -g -O0 -Wno-unused-parameter
                         -ffile-prefix-map=${PROJECT_SOURCE_DIR}/=
                         -ffile-prefix-map=${CMAKE_CURRENT_BINARY_DIR}/=)
# With the soname of the library: programs ask for that too.
set_target_properties(
  grit_described PROPERTIES OUTPUT_NAME grit VERSION ${PROJECT_VERSION} SOVERSION ${GRIT_SOVERSION} C_STANDARD 11
                            LIBRARY_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR}/described)

set(baseline ${CMAKE_CURRENT_SOURCE_DIR}/grit-0.1.abi)
add_test(NAME Abi.KeepsTheBaselineOfAbidiff
         COMMAND ${GRIT_ABIDIFF} --no-added-syms --suppressions
                 ${CMAKE_CURRENT_SOURCE_DIR}/growth.suppr ${baseline} $<TARGET_FILE:grit_described>)
# After a deliberate change of the interface: cmake --build BUILD --target abi-baseline, and commit.
add_custom_target(
  abi-baseline
  COMMAND ${GRIT_ABIDW} --no-corpus-path --no-comp-dir-path --no-show-locs --no-elf-needed
          --out-file ${baseline} $<TARGET_FILE:grit_described>
  DEPENDS grit_described
  VERBATIM)
