# How Grit compiles: one set of flags, object libraries per folder, and the two libraries made of them.

include(CheckCXXCompilerFlag)

# What may change: everything with a major version, and layouts with a minor one before 1.0.
if(PROJECT_VERSION_MAJOR EQUAL 0)
  set(GRIT_SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  set(GRIT_COMPATIBILITY SameMinorVersion)
else()
  set(GRIT_SOVERSION ${PROJECT_VERSION_MAJOR})
  set(GRIT_COMPATIBILITY SameMajorVersion)
endif()

# What is compiled into everything beside the program itself, and makes it slow.
set(GRIT_SANITIZERS address,undefined,float-cast-overflow)
set(GRIT_INSTRUMENTATION)
if(GRIT_SANITIZE STREQUAL "THREAD")
  set(GRIT_SANITIZERS thread)
  set(GRIT_INSTRUMENTATION -fsanitize=thread)
elseif(GRIT_SANITIZE)
  set(GRIT_INSTRUMENTATION -fsanitize=address,undefined)
endif()
set(GRIT_COUNTS)
if(GRIT_COVERAGE)
  set(GRIT_COUNTS -fprofile-instr-generate -fcoverage-mapping)
  list(APPEND GRIT_INSTRUMENTATION ${GRIT_COUNTS})
endif()
set(GRIT_INSTRUMENTED OFF)
if(GRIT_INSTRUMENTATION)
  set(GRIT_INSTRUMENTED ON)
endif()

# For the calling folder: what tests do not wait for is instrumented as it is written, a third of the time to compile.
# Fuzzers wait for everything.
macro(grit_instrument_as_written)
  if(GRIT_INSTRUMENTED AND NOT GRIT_BUILD_FUZZERS)
    add_compile_options(-O0)
  endif()
endmacro()

# What a library for hosts leaves open is an error; the sanitizers of clang are in the program that loads it.
set(GRIT_COMPLETE_LIBRARY -Wl,--no-undefined)
if(GRIT_INSTRUMENTED AND CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(GRIT_COMPLETE_LIBRARY)
endif()

# Flags of some compilers only, into the list RESULT: what this one understands of them.
function(grit_flags_of_this_compiler result)
  set(known)
  foreach(flag IN LISTS ARGN)
    string(MAKE_C_IDENTIFIER "GRIT_HAS${flag}" has)
    string(REGEX REPLACE "^-Wno-" "-W" asked ${flag}) # any -Wno- is accepted
    check_cxx_compiler_flag(${asked} ${has})
    if(${has})
      list(APPEND known ${flag})
    endif()
  endforeach()
  set(${result} ${known} PARENT_SCOPE)
endfunction()

# g++ speaks of the calling convention of wide vectors and of their attributes as template arguments, which
# never leave a kernel; clang of masks that are plain bools and joined without a branch.
grit_flags_of_this_compiler(GRIT_VECTOR_FLAGS -Wno-psabi -Wno-ignored-attributes -Wno-bitwise-instead-of-logical)
# A pass over whole functions that takes a fifth of the time to compile a kernel, and makes none faster.
grit_flags_of_this_compiler(GRIT_KERNEL_FLAGS -fno-gcse)
# What is to be fast. Instrumented kernels take g++ minutes to optimise, a fifth of it for where pointers point to.
set(GRIT_FAST_FLAGS -O3)
if(GRIT_INSTRUMENTED AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  set(GRIT_FAST_FLAGS -O1 -fno-tree-pta)
endif()
list(APPEND GRIT_FAST_FLAGS -ffp-contract=off -fno-math-errno -fno-trapping-math ${GRIT_VECTOR_FLAGS})
# Bad pointers are what the address sanitizer sees: checks of them by the other take a third of the time to compile, of
# pointers that run over nine tenths of that of a kernel. How what they point to is aligned, readers of files are asked:
# the fuzzers. Hosts call an entry by a type of their own.
set(GRIT_UNCHECKED null,object-size)
if(NOT GRIT_BUILD_FUZZERS)
  string(APPEND GRIT_UNCHECKED ,alignment)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  string(APPEND GRIT_UNCHECKED ,pointer-overflow,function)
endif()
# Every load of an unrolled kernel would be checked in place: the sanitizer is called instead. Its guards around each
# local pack cost three quarters of the time to compile; the bounds of local arrays are checked without them.
if(CMAKE_CXX_COMPILER_ID MATCHES Clang)
  set(GRIT_SANITIZED_KERNEL_FLAGS -mllvm -asan-instrumentation-with-call-threshold=0 -mllvm -asan-stack=0)
else()
  set(GRIT_SANITIZED_KERNEL_FLAGS --param=asan-instrumentation-with-call-threshold=0 --param=asan-stack=0)
endif()
list(APPEND GRIT_SANITIZED_KERNEL_FLAGS -fno-sanitize=alignment)
# Fuzzers count the ways through what judges a call; those through a kernel are too many to compile.
if(GRIT_BUILD_FUZZERS)
  list(APPEND GRIT_SANITIZED_KERNEL_FLAGS -fno-sanitize=fuzzer-no-link)
endif()
# Structs are copied in whole registers: half of one that was just stored whole, or the reverse, waits for
# the cache. GCC's default is 16 bytes.
grit_flags_of_this_compiler(GRIT_AVX2_FLAGS -mmove-max=256 -mstore-max=256)
# g++ 12 warns about its own AVX-512 header.
grit_flags_of_this_compiler(GRIT_AVX512_FLAGS -Wno-uninitialized -Wno-maybe-uninitialized)

# Warnings and sanitizers for everything that is built here; errors only when Grit is on top.
function(grit_warnings target)
  target_compile_features(${target} PUBLIC cxx_std_20)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wshadow $<$<BOOL:${PROJECT_IS_TOP_LEVEL}>:-Werror>)
  if(GRIT_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${GRIT_SANITIZERS} -fno-sanitize=${GRIT_UNCHECKED} -fno-sanitize-recover=all)
  endif()
  target_compile_options(${target} PRIVATE ${GRIT_COUNTS})
  target_link_options(${target} PRIVATE ${GRIT_INSTRUMENTATION})
  if(GRIT_BUILD_FUZZERS)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# Symbols of a target that goes into a library for hosts stay inside it.
function(grit_hidden target)
  set_target_properties(
    ${target}
    PROPERTIES CXX_VISIBILITY_PRESET hidden
               VISIBILITY_INLINES_HIDDEN ON
               POSITION_INDEPENDENT_CODE ON)
endfunction()

# Code inside libgrit, which sees support and ROOMS: hidden symbols, IEEE arithmetic as written, no contraction behind our back.
function(grit_library_part target)
  cmake_parse_arguments(part "" "" "ROOMS;SOURCES" ${ARGN})
  add_library(${target} OBJECT ${part_SOURCES})
  grit_warnings(${target})
  grit_sees(${target} PRIVATE support ${part_ROOMS})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(${target} PRIVATE GRIT_BUILDING)
  target_compile_options(
    ${target} PRIVATE ${GRIT_FAST_FLAGS} ${GRIT_KERNEL_FLAGS})
  grit_hidden(${target})
  set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
  if(GRIT_X86_KERNELS)
    target_compile_definitions(${target} PRIVATE GRIT_HAS_X86_KERNELS)
  endif()
  set_property(GLOBAL APPEND PROPERTY GRIT_PARTS ${target})
endfunction()

# One source per kernel named and instruction set that this processor family has: kernel_baseline.cpp and so on,
# in the calling folder, into the list RESULT. Or one for the machine that builds, which takes less than half the
# time to compile: it counts as the baseline, and there is no other. Or the baseline itself alone.
set(GRIT_X86_KERNELS OFF)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT GRIT_NATIVE AND NOT GRIT_BASELINE_ONLY)
  set(GRIT_X86_KERNELS ON)
endif()
macro(grit_kernels result)
  set(of_baseline)
  if(GRIT_NATIVE)
    list(APPEND of_baseline -march=native ${GRIT_AVX512_FLAGS})
  endif()
  if(GRIT_SANITIZE)
    list(APPEND of_baseline ${GRIT_SANITIZED_KERNEL_FLAGS})
  endif()
  set(of_avx2 -mavx2 -mfma ${GRIT_AVX2_FLAGS})
  set(of_avx512 -mavx512f -mavx512vl -mavx512dq -mfma ${GRIT_AVX512_FLAGS})
  set(sets baseline)
  if(GRIT_X86_KERNELS)
    list(APPEND sets avx2 avx512)
  endif()
  set(${result})
  foreach(kernel ${ARGN})
    foreach(set IN LISTS sets)
      list(APPEND ${result} ${kernel}_${set}.cpp)
      set_source_files_properties(${kernel}_${set}.cpp PROPERTIES COMPILE_OPTIONS "${of_${set}}")
    endforeach()
  endforeach()
endmacro()

# Grit::grit (shared) and Grit::grit_static (PIC), of the parts declared so far.
function(grit_add_libraries)
  get_property(parts GLOBAL PROPERTY GRIT_PARTS)
  set(objects)
  foreach(part IN LISTS parts)
    list(APPEND objects $<TARGET_OBJECTS:${part}>)
  endforeach()
  add_library(grit SHARED ${objects})
  add_library(grit_static STATIC ${objects})
  set_target_properties(grit PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${GRIT_SOVERSION})
  target_link_options(grit PRIVATE ${GRIT_COMPLETE_LIBRARY} -Wl,--as-needed)
  set_target_properties(grit_static PROPERTIES OUTPUT_NAME grit) # as -static looks for it
  target_link_libraries(grit_static INTERFACE m)
  foreach(library grit grit_static)
    add_library(Grit::${library} ALIAS ${library})
    set_target_properties(${library} PROPERTIES LINKER_LANGUAGE CXX)
    target_include_directories(
      ${library} INTERFACE $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                           $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
    target_link_options(${library} PUBLIC ${GRIT_INSTRUMENTATION})
  endforeach()
endfunction()
