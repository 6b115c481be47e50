# Flags that every target of this project shares.
#
# similitude_flags(target): warnings, instruction set, sanitizers. No fast-math anywhere: results are the same bits
# for any thread count, and a plugin must not change the processor's rounding state.
# -fno-math-errno and -fno-trapping-math let loops with sqrt vectorise and change no result.
function(similitude_flags target)
  target_compile_options(${target} PRIVATE -Wall -Wextra -Wconversion -fno-math-errno -fno-trapping-math -ffp-contract=fast)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE -Wno-restrict -Wno-psabi)   # GCC 12 sees overlaps in std::string where there are none (PR 105651)
  endif()
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(${target} PRIVATE -Wno-pass-failed)   # a loop that Clang cannot vectorise is slower, not wrong
  endif()
  if(SIMILITUDE_WERROR)
    target_compile_options(${target} PRIVATE -Werror)
  endif()
  if(SIMILITUDE_MARCH)
    target_compile_options(${target} PRIVATE -march=${SIMILITUDE_MARCH})
  endif()
  if(SIMILITUDE_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=${SIMILITUDE_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(${target} PRIVATE -fsanitize=${SIMILITUDE_SANITIZE})
  endif()
endfunction()

# similitude_part(name SOURCES … LINKS … PRIVATE_LINKS …): one folder of framework/ as a static library
# similitude_<name>, for tests; libsimilitude is made of the same objects. A part links only parts above it in the house.
function(similitude_part name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(similitude_${name}_objects OBJECT ${ARG_SOURCES})
  target_include_directories(similitude_${name}_objects PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/framework>)
  target_link_libraries(similitude_${name}_objects PUBLIC similitude_sdk ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})
  similitude_flags(similitude_${name}_objects)
  add_library(similitude_${name} STATIC $<TARGET_OBJECTS:similitude_${name}_objects>)
  target_include_directories(similitude_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/framework>)
  target_link_libraries(similitude_${name} PUBLIC similitude_sdk ${ARG_LINKS} PRIVATE ${ARG_PRIVATE_LINKS})

  set(externals ${ARG_LINKS} ${ARG_PRIVATE_LINKS})
  list(FILTER externals EXCLUDE REGEX "^similitude_")
  set_property(GLOBAL APPEND PROPERTY SIMILITUDE_PARTS similitude_${name})
  set_property(GLOBAL APPEND PROPERTY SIMILITUDE_EXTERNALS ${externals})
endfunction()

# similitude_test(name SOURCES … LINKS … [LABELS …]): a GoogleTest program whose cases ctest sees one by one.
function(similitude_test name)
  cmake_parse_arguments(ARG "" "TIMEOUT" "SOURCES;LINKS;LABELS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINKS} GTest::gtest GTest::gtest_main GTest::gmock)
  similitude_flags(${name})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  set(labels unit)
  if(ARG_LABELS)
    set(labels ${ARG_LABELS})
  endif()
  gtest_discover_tests(${name} DISCOVERY_TIMEOUT 60 PROPERTIES TIMEOUT ${ARG_TIMEOUT} LABELS "${labels}"
    ENVIRONMENT "OMP_WAIT_POLICY=passive;OMP_NUM_THREADS=1")   # tests run side by side; those of threads ask for them
endfunction()
