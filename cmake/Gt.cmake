# How this project builds: the compiler's settings, and one function for each kind of target.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
# Editors look for it at the root: that of the preset which was configured last.
file(CREATE_LINK ${CMAKE_BINARY_DIR}/compile_commands.json ${PROJECT_SOURCE_DIR}/compile_commands.json SYMBOLIC)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

find_program(CCACHE ccache)
if(CCACHE)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${PROJECT_SOURCE_DIR}/cmake/compile)
endif()
set(GT_SANITIZE "" CACHE STRING "Sanitizers to build with, as for -fsanitize=: address,undefined or thread")
find_program(MOLD mold)
if(MOLD)
  add_link_options(-fuse-ld=mold)
  # What a shared library leaves open mold would take from our archives, with all that the taken part needs, unless a library
  # before them has it. A sanitizer's library must come first itself.
  if(NOT GT_SANITIZE)
    add_link_options(-lstdc++)
  endif()
endif()

# The same seed gives the same bits: no contraction of a*b+c that one compiler does and another does not.
add_compile_options(-Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror -ffp-contract=off)
# The Python package links the libraries into a shared one.
add_compile_options(-fPIC -fno-semantic-interposition)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  add_compile_options(-Wno-restrict)  # gcc 12 warns of its own std::string (GCC bug 105651)
  # Most units end before so many kilobytes need to be searched for garbage, which takes 5 to 9 % of the time of the larger ones.
  add_compile_options("SHELL:--param ggc-min-heapsize=800000")
endif()
set(CMAKE_CXX_FLAGS_RELEASE "-O3")  # with assertions, as in all builds
set(CMAKE_CXX_FLAGS_RELWITHDEBINFO "-O2 -g")

if(GT_SANITIZE)
  add_compile_options(-fsanitize=${GT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all -g1)
  add_link_options(-fsanitize=${GT_SANITIZE})
  # Between its checks gcc sees reads that never happen; the release build looks for those. The thread sanitizer knows no
  # fences: ours order memory that another program reads, which it does not see either.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overread> $<$<CXX_COMPILER_ID:GNU>:-Wno-tsan>)
endif()

# Programs without symbols, as they go to a robot, and beside them these, of the same build id, for crashlog --symbols.
option(GT_SPLIT_SYMBOLS "Source lines of all programs as bin/symbols/*.debug" OFF)
if(GT_SPLIT_SYMBOLS)
  find_program(OBJCOPY objcopy REQUIRED)
  add_compile_options(-g1)
  add_link_options(-Wl,--build-id)
endif()

option(GT_DEBUGGING "Debug keys, drawings, plots and texts; off takes them out of the program" ON)
if(NOT GT_DEBUGGING)
  add_compile_definitions(GT_NO_DEBUGGING)
endif()

# What runs but once (the reading of options and files) is rather built fast than built for speed, and tests as fast as can be.
set(coldCode $<$<CONFIG:Release>:-O1>)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  list(APPEND coldCode $<$<CONFIG:Release>:-Wno-maybe-uninitialized>)  # with -O1, gcc 12 warns of its std::optional
endif()
set(hotCode $<$<CONFIG:Release>:-O3> $<$<CONFIG:RelWithDebInfo>:-O2>)
set(testCode $<$<NOT:$<CONFIG:Debug>>:-O0>)

find_package(Threads REQUIRED)
# Without these only programs are built, as `make play` does.
find_package(GTest QUIET)
if(NOT GTest_FOUND)
  message(STATUS "GoogleTest is missing: tests are not built (make test installs it)")
endif()

# Headers that nearly all files of a target include are compiled once. Each file still includes what it needs: the preset
# "clang" builds without.
option(GT_PRECOMPILE "Precompile headers (gcc)" ON)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(GT_PRECOMPILE OFF)
endif()
# gt_precompile(target <header>... | REUSE_FROM other)
function(gt_precompile target)
  if(GT_PRECOMPILE)
    cmake_parse_arguments(ARG "" "REUSE_FROM" "" ${ARGN})
    if(ARG_REUSE_FROM)
      target_precompile_headers(${target} REUSE_FROM ${ARG_REUSE_FROM})
    else()
      target_precompile_headers(${target} PRIVATE ${ARGN})
    endif()
    # With them gcc 12 warns of what it inlines from its own std::string (GCC bug 105329).
    target_compile_options(${target} PRIVATE -Wno-array-bounds -Wno-stringop-overflow -Wno-stringop-overread)
  endif()
endfunction()

# One for each way to compile; for gcc -O1 and -O3 are the same way. A change in a header that is in all of them builds everything: so
# these are such as seldom change, and none of a module. What their inline functions use of templates is compiled again in each unit that
# takes them: many files in a unit, and no more headers than nearly all need.
find_package(Eigen3 REQUIRED)
function(gt_precompiled name)
  if(NOT GT_PRECOMPILE)
    return()
  endif()
  cmake_parse_arguments(ARG "" "CODE" "DEPS;HEADERS" ${ARGN})
  add_library(${name} OBJECT ${PROJECT_SOURCE_DIR}/cmake/Precompiled.cpp)
  target_compile_options(${name} PRIVATE ${ARG_CODE})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${name} PRIVATE Eigen3::Eigen ${ARG_DEPS})
  gt_precompile(${name}
    <algorithm> <filesystem> <functional> <map> <memory> <optional> <sstream> <string> <unordered_map> <vector>
    <Eigen/Geometry> <base/Geometry.h> <base/Random.h> <base/Result.h> <streams/Binary.h> <streams/MessageQueue.h>
    <debug/Debug.h> ${ARG_HEADERS})
endfunction()
gt_precompiled(gt_precompiled_code)
gt_precompiled(gt_precompiled_programs CODE ${coldCode} HEADERS <CLI/CLI.hpp> <fstream> <iostream>)
if(GTest_FOUND)
  gt_precompiled(gt_precompiled_tests CODE ${testCode} DEPS GTest::gmock HEADERS <gmock/gmock.h>)
endif()

# Most of the time of a build goes into headers. Where speed does not matter, several files of a target are compiled as one,
# so that their own names have to differ (the test united_names checks it); the preset "clang" compiles each by itself. CMake's own
# unity builds include files by absolute paths, so that ccache could not serve another clone.
option(GT_UNITE "Compile several files of tests and cold code as one (gcc)" ON)
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  set(GT_UNITE OFF)
endif()
set_property(GLOBAL PROPERTY GT_UNITED "")
# gt_unite(target [COUNT]): COUNT (18) of its sources each that are neither generated nor compiled in a way of their own, as they are set
# at the end of its folder. Few where people wait for a change of one file.
function(gt_unite target)
  if(GT_UNITE)
    set(filesUnited ${ARGN} 18)
    list(GET filesUnited 0 filesUnited)
    # One file shadows another's names; and gcc takes the nameless namespace of an included file for one that many include.
    target_compile_options(${target} PRIVATE -Wno-shadow -Wno-subobject-linkage)
    cmake_language(EVAL CODE "cmake_language(DEFER CALL gt_unite_sources ${target} ${filesUnited})")
  endif()
endfunction()
function(gt_unite_sources target filesUnited)
  get_target_property(sources ${target} SOURCES)
  set(single)
  set(united)
  foreach(source ${sources})
    get_filename_component(file ${source} ABSOLUTE)
    cmake_path(IS_PREFIX CMAKE_BINARY_DIR ${file} generated)
    set(own ${generated})
    foreach(property COMPILE_OPTIONS COMPILE_DEFINITIONS INCLUDE_DIRECTORIES SKIP_UNITY_BUILD_INCLUSION)
      get_source_file_property(value ${source} ${property})
      if(value)
        set(own TRUE)
      endif()
    endforeach()
    if(own)
      list(APPEND single ${source})
    else()
      list(APPEND united ${file})
    endif()
  endforeach()
  set_property(GLOBAL APPEND_STRING PROPERTY GT_UNITED "${target} ${united}\n")
  list(LENGTH united count)
  set(first 0)
  while(first LESS count)
    list(SUBLIST united ${first} ${filesUnited} files)
    set(batch "")
    foreach(file ${files})
      file(RELATIVE_PATH path ${CMAKE_CURRENT_BINARY_DIR} ${file})
      string(APPEND batch "#include \"${path}\"\n")
    endforeach()
    file(CONFIGURE OUTPUT ${target}_${first}.cpp CONTENT "${batch}" @ONLY)
    list(APPEND single ${CMAKE_CURRENT_BINARY_DIR}/${target}_${first}.cpp)
    math(EXPR first "${first} + ${filesUnited}")
  endwhile()
  set_target_properties(${target} PROPERTIES SOURCES "${single}")
endfunction()
# gt_list_united(): writes united.txt, a line for each target: its name and the files that are compiled as one. To be called behind
# all folders.
function(gt_list_united)
  if(GT_UNITE)
    get_property(united GLOBAL PROPERTY GT_UNITED)
    file(WRITE ${CMAKE_BINARY_DIR}/united.txt "${united}")
  endif()
endfunction()

# gt_library(name [COLD] [APART] SOURCES a.cpp ... [DEFINITIONS c.cpp ...] TESTS a_test.cpp ... DEPS gt_base ... [TEST_DEPS ...]
#   [HOT b.cpp ... | HOT_TESTS])
# One folder is one library. Without sources it is a library of headers. Its tests become the program <name>_test, which links
# TEST_DEPS, too. What is cold runs but once, besides the sources that are hot. Sources that are apart are compiled each by itself: they
# are linked singly, so that a program has only the modules that it runs, or broken singly by scripts/mutants. Definitions are sources
# that say what representation() returns (framework/RepresentationDefinition.h): in one unit with others they would say it there, too.
# Hot tests compute much.
function(gt_library name)
  cmake_parse_arguments(ARG "COLD;APART;HOT_TESTS" "" "SOURCES;DEFINITIONS;TESTS;DEPS;TEST_DEPS;HOT" ${ARGN})
  if(ARG_SOURCES)
    add_library(${name} STATIC ${ARG_DEFINITIONS} ${ARG_SOURCES})
    set_source_files_properties(${ARG_DEFINITIONS} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    set(filesUnited 8)
    if(ARG_COLD)
      set(filesUnited)
      target_compile_options(${name} PRIVATE ${coldCode})
    endif()
    if(NOT ARG_APART)
      gt_unite(${name} ${filesUnited})
    endif()
    set_source_files_properties(${ARG_HOT} PROPERTIES COMPILE_OPTIONS "${hotCode}")
    gt_precompile(${name} REUSE_FROM gt_precompiled_code)
    target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>)
    target_link_libraries(${name} PUBLIC ${ARG_DEPS})
  else()
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(${name} INTERFACE ${ARG_DEPS})
  endif()
  if(ARG_TESTS)
    if(ARG_HOT_TESTS)
      set(hot HOT)
    endif()
    gt_test(${name}_test ${hot} SOURCES ${ARG_TESTS} DEPS ${name} ${ARG_TEST_DEPS})
  endif()
endfunction()

# gt_test(name [HOT] SOURCES a_test.cpp ... DEPS ...): a program of GoogleTest, run in the root of the sources. Its label is its folder
# (scripts/changed-tests).
function(gt_test name)
  if(NOT GTest_FOUND)
    return()
  endif()
  cmake_parse_arguments(ARG "HOT" "" "SOURCES;DEPS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  if(ARG_HOT)
    target_compile_options(${name} PRIVATE ${coldCode})
    gt_precompile(${name} REUSE_FROM gt_precompiled_code)
  else()
    target_compile_options(${name} PRIVATE ${testCode})
    gt_precompile(${name} REUSE_FROM gt_precompiled_tests)
  endif()
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR}/tests)  # of tests/support
  target_link_libraries(${name} PRIVATE ${ARG_DEPS} GTest::gmock GTest::gtest_main)
  gt_unite(${name})
  add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  set_tests_properties(${name} PROPERTIES LABELS ${folder})
endfunction()

# gt_program(name [HOT] [COMPONENT component] SOURCES main.cpp ... DEPS ...): a program under bin/, which is installed if it was built,
# with the component "programs" unless another is named. What it has of its own reads options and prints, unless it is hot.
function(gt_program name)
  cmake_parse_arguments(ARG "HOT" "COMPONENT" "SOURCES;DEPS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  if(NOT ARG_HOT)
    target_compile_options(${name} PRIVATE ${coldCode})
    gt_precompile(${name} REUSE_FROM gt_precompiled_programs)
    gt_unite(${name} 5)  # the last to be compiled: by all processors
  endif()
  target_link_libraries(${name} PRIVATE ${ARG_DEPS})
  if(NOT ARG_COMPONENT)
    set(ARG_COMPONENT programs)
  endif()
  install(TARGETS ${name} OPTIONAL COMPONENT ${ARG_COMPONENT})
  if(GT_SPLIT_SYMBOLS)
    set(symbols ${CMAKE_RUNTIME_OUTPUT_DIRECTORY}/symbols)
    add_custom_command(TARGET ${name} POST_BUILD
      COMMAND ${CMAKE_COMMAND} -E make_directory ${symbols}
      COMMAND ${OBJCOPY} --only-keep-debug $<TARGET_FILE:${name}> ${symbols}/${name}.debug
      COMMAND ${OBJCOPY} --strip-debug --add-gnu-debuglink=${symbols}/${name}.debug $<TARGET_FILE:${name}>
      VERBATIM)
  endif()
endfunction()

# gt_embed(output.cpp HEADER header.h NAMESPACE name FILES name=path ...): files as a part of the program: a source file in
# the binary folder with a function for each, as the header declares them.
function(gt_embed output)
  cmake_parse_arguments(ARG "" "HEADER;NAMESPACE" "FILES" ${ARGN})
  list(TRANSFORM ARG_FILES REPLACE "^[^=]*=" "" OUTPUT_VARIABLE embedded)
  add_custom_command(
    OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${output}
    COMMAND ${CMAKE_COMMAND} -Dheader=${ARG_HEADER} -Dnamespace=${ARG_NAMESPACE} "-Dfiles=${ARG_FILES}"
            -Doutput=${CMAKE_CURRENT_BINARY_DIR}/${output} -P ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    DEPENDS ${embedded} ${PROJECT_SOURCE_DIR}/cmake/EmbedFiles.cmake
    VERBATIM)
endfunction()

# gt_node_test(name program.mjs argument...): a program of this folder, run by Node in the root of the sources with the
# packages of the folder's package-lock.json, which are fetched once for each build folder.
function(gt_node_test name program)
  get_filename_component(folder ${CMAKE_CURRENT_SOURCE_DIR} NAME)
  add_test(NAME ${name}
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/run-node ${CMAKE_BINARY_DIR}/node/${folder} ${CMAKE_CURRENT_SOURCE_DIR} ${program} ${ARGN}
    WORKING_DIRECTORY ${PROJECT_SOURCE_DIR})
endfunction()
