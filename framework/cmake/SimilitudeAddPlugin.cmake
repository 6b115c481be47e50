# similitude_add_plugin(<name> KIND <kind> SOURCES … [LINKS …] [TEST …]): one plugin library, <kind>_<name>.so.
#
#   KIND     drag, contact, fluid, scaling or effect. A fluid plugin links libsimilitude; all others need headers only.
#   SOURCES  usually one file, in C++ or in what fills the C boundary: C, Fortran
#   LINKS    further libraries, private to the plugin
#   TEST     sources of a GoogleTest program, which finds the library's path in the macro SIMILITUDE_PLUGIN_FILE
#
# The target is <kind>_<name>. Out of tree, after enable_testing(), the test <kind>_<name>_doctor has the program examine the
# library (`similitude plugins doctor`). This file serves the framework's own plugins and, installed, everybody else's:
#   find_package(similitude 1.0 REQUIRED COMPONENTS sdk)
#   similitude_add_plugin(my_law KIND drag SOURCES my_law.cpp)
# There the library lands in the project's build folder, which a case names under plugin_paths, and `cmake --install`
# puts it where the program under the same prefix finds it. SIMILITUDE_MARCH chooses the instruction set (native).
include_guard(GLOBAL)
include(GNUInstallDirs)

function(similitude_add_plugin name)
  cmake_parse_arguments(ARG "" "KIND" "SOURCES;LINKS;TEST" ${ARGN})
  set(kinds drag contact fluid scaling effect)
  if(NOT name MATCHES "^[a-z][a-z0-9_]*$")
    message(FATAL_ERROR "similitude_add_plugin(${name}): a plugin's name is lower_snake, e.g. my_law.")
  endif()
  if(NOT ARG_KIND IN_LIST kinds)
    message(FATAL_ERROR "similitude_add_plugin(${name}): there is no kind \"${ARG_KIND}\". Use KIND with one of: ${kinds}.")
  endif()
  if(NOT ARG_SOURCES)
    message(FATAL_ERROR "similitude_add_plugin(${name}): no sources. Add SOURCES ${name}.cpp.")
  endif()
  if(ARG_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "similitude_add_plugin(${name}): unknown arguments: ${ARG_UNPARSED_ARGUMENTS}.")
  endif()

  set(target ${ARG_KIND}_${name})
  add_library(${target} MODULE ${ARG_SOURCES})
  if(CMAKE_CXX_COMPILER_LOADED)
    target_compile_features(${target} PRIVATE cxx_std_20)
  endif()
  set_target_properties(${target} PROPERTIES
    PREFIX "" SUFFIX ".so" CXX_EXTENSIONS OFF
    C_VISIBILITY_PRESET hidden CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
  # A type that is unique in the process would tie a plugin to its neighbours.
  target_compile_options(${target} PRIVATE $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-gnu-unique>)

  if(COMMAND similitude_flags)
    similitude_flags(${target})
    set(sdk similitude_sdk)
    set(framework similitude)
    set(output ${SIMILITUDE_PLUGIN_OUTPUT_DIRECTORY})
  else()
    set(SIMILITUDE_MARCH native CACHE STRING "instruction set: native, x86-64-v3, x86-64-v4, …")
    target_compile_options(${target} PRIVATE -fno-math-errno -fno-trapping-math -ffp-contract=fast
      $<$<BOOL:${SIMILITUDE_MARCH}>:-march=${SIMILITUDE_MARCH}>
      $<$<CONFIG:>:-O3>)   # no build type chosen: a law runs millions of times a second
    set(sdk similitude::sdk)
    set(framework similitude::framework)
    set(output ${CMAKE_CURRENT_BINARY_DIR})
    if(SIMILITUDE_PLUGIN_OUTPUT_DIRECTORY)
      set(output ${SIMILITUDE_PLUGIN_OUTPUT_DIRECTORY})
    endif()
  endif()
  set_target_properties(${target} PROPERTIES LIBRARY_OUTPUT_DIRECTORY ${output})

  target_link_libraries(${target} PRIVATE ${sdk} ${ARG_LINKS})
  if(ARG_KIND STREQUAL fluid)
    if(NOT TARGET ${framework})
      message(FATAL_ERROR "similitude_add_plugin(${name}): a fluid plugin links libsimilitude. "
        "Ask for it: find_package(similitude 1.0 REQUIRED COMPONENTS sdk framework).")
    endif()
    target_link_libraries(${target} PRIVATE ${framework})
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/../..")
  endif()

  # Nothing is visible from outside but the entry, and what is missing is missed at link time, not in the middle of a run.
  set(exports ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/similitude_plugin.map)
  target_link_options(${target} PRIVATE "LINKER:--version-script=${exports}")
  set_property(TARGET ${target} APPEND PROPERTY LINK_DEPENDS ${exports})
  if(NOT SIMILITUDE_SANITIZE AND NOT "${CMAKE_CXX_FLAGS} ${CMAKE_MODULE_LINKER_FLAGS}" MATCHES "-fsanitize")
    target_link_options(${target} PRIVATE "LINKER:--no-undefined")
  endif()

  # Flags may still be added to the target or its folder: look when the folder is complete.
  cmake_language(EVAL CODE "cmake_language(DEFER CALL similitude_refuse_fast_math [[${target}]])")

  if(NOT SIMILITUDE_PLUGIN_INSTALL_DIRECTORY)
    set(SIMILITUDE_PLUGIN_INSTALL_DIRECTORY ${CMAKE_INSTALL_LIBDIR}/similitude/plugins)
  endif()
  install(TARGETS ${target} LIBRARY DESTINATION ${SIMILITUDE_PLUGIN_INSTALL_DIRECTORY} COMPONENT plugins)

  if(SIMILITUDE_PROGRAM)
    add_test(NAME ${target}_doctor COMMAND ${SIMILITUDE_PROGRAM} plugins doctor $<TARGET_FILE:${target}>)
  endif()
  if(ARG_TEST)
    similitude_add_plugin_test(${target} ${sdk} ${ARG_TEST})
  endif()
endfunction()

# The GoogleTest program of one plugin: <kind>_<name>_test.
function(similitude_add_plugin_test target sdk)
  if(COMMAND similitude_test)
    if(NOT SIMILITUDE_TESTS)
      return()
    endif()
    similitude_test(${target}_test SOURCES ${ARGN} LINKS ${sdk} ${CMAKE_DL_LIBS})
  else()
    include(CTest)
    if(NOT BUILD_TESTING)
      return()
    endif()
    find_package(GTest QUIET)
    if(NOT GTest_FOUND)
      message(STATUS "${target}: GoogleTest is not installed, so its test is left out.")
      return()
    endif()
    add_executable(${target}_test ${ARGN})
    target_link_libraries(${target}_test PRIVATE ${sdk} GTest::gtest GTest::gtest_main ${CMAKE_DL_LIBS})
    add_test(NAME ${target}_test COMMAND ${target}_test)
  endif()
  target_compile_definitions(${target}_test PRIVATE SIMILITUDE_PLUGIN_FILE="$<TARGET_FILE:${target}>")
  add_dependencies(${target}_test ${target})
endfunction()

# Fast-math makes results depend on the optimiser's mood, and its start-up code switches the whole process to flushing
# small numbers to zero. The program refuses such a library; refusing the flag is kinder.
function(similitude_refuse_fast_math target)
  string(TOUPPER "${CMAKE_BUILD_TYPE}" config)
  get_target_property(options ${target} COMPILE_OPTIONS)
  get_target_property(link_options ${target} LINK_OPTIONS)
  get_target_property(flags ${target} COMPILE_FLAGS)
  set(all "${options} ${link_options} ${flags}")
  foreach(language C CXX Fortran)
    string(APPEND all " ${CMAKE_${language}_FLAGS} ${CMAKE_${language}_FLAGS_${config}}")
  endforeach()
  if(all MATCHES "(-ffast-math|-Ofast|-funsafe-math-optimizations)")
    message(FATAL_ERROR "${target}: ${CMAKE_MATCH_1} is among its flags, and a plugin must not be built with it. "
      "Remove it: -fno-math-errno and -fno-trapping-math, which let loops vectorise, are set already.")
  endif()
endfunction()
