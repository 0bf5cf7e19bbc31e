# One helper per kind of thing; sources are found by folder, nothing is listed by hand.

file(GLOB TRAMMEL_RTL_DIRS LIST_DIRECTORIES true CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*)
list(FILTER TRAMMEL_RTL_DIRS EXCLUDE REGEX "/boards$")
set(TRAMMEL_RTL_SEARCH ${TRAMMEL_RTL_DIRS})
list(TRANSFORM TRAMMEL_RTL_SEARCH PREPEND -I)
list(APPEND TRAMMEL_RTL_SEARCH -I${PROJECT_SOURCE_DIR}/rtl/chips/generated)
file(GLOB TRAMMEL_RTL_PACKAGES CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/rtl/pkg/*_pkg.sv ${PROJECT_SOURCE_DIR}/rtl/math/*_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/chips/generated/*_pkg.sv)
file(GLOB TRAMMEL_RTL_PROPERTIES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/*_props.sv)
list(FILTER TRAMMEL_RTL_PROPERTIES EXCLUDE REGEX "/boards/")

# A library of all .cpp files of a folder tree (header-only: an INTERFACE library).
function(trammel_library name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/verilated/|/rv32im/")  # see cosim/, scripts/firmware.py
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC trammel_options ${ARGN})
    trammel_unity_if_checked(${name})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE trammel_options ${ARGN})
  endif()
endfunction()

# Checks and counts in every template of a header library take long to compile: once a folder.
function(trammel_unity_if_checked name)
  if(TRAMMEL_BASE)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()

# An executable of Catch2 cases; every case becomes a test named <prefix>.<case>.
function(trammel_test name source prefix)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE trammel_options trammel_catch_main ${ARGN})
  add_dependencies(trammel_checked ${name})
  add_test(NAME ${prefix} COMMAND ${name})
  set_tests_properties(${prefix} PROPERTIES TIMEOUT 300)
endfunction()

# A library of verilated models. Their headers are not ours: no warnings from them. With
# TRAMMEL_BASE it is that of another build of these sources, and nothing is verilated.
function(trammel_verilated_library name)
  if(TRAMMEL_BASE)
    trammel_imported_library(${name})
    target_include_directories(${name} INTERFACE ${VERILATOR_ROOT}/include
      ${VERILATOR_ROOT}/include/vltstd)
    target_link_libraries(${name} INTERFACE z Threads::Threads)
  else()
    add_library(${name} STATIC ${ARGN})
  endif()
  set_property(TARGET ${name} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES
    $<TARGET_PROPERTY:${name},INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# verilate(library ...) with the model as one unit of that name, compiled with these options: its
# many small ones take twice as long to compile.
function(trammel_verilate library name options)
  get_target_property(before ${library} SOURCES)
  verilate(${library} ${ARGN})
  if(TRAMMEL_BASE)
    return()
  endif()
  get_target_property(files ${library} SOURCES)
  list(REMOVE_ITEM files ${before})
  list(FILTER files INCLUDE REGEX "/verilated/.*\\.cpp$")
  list(TRANSFORM files REPLACE "(.+)" "#include \"\\1\"\n" OUTPUT_VARIABLE includes)
  string(CONCAT text ${includes})
  set(unit ${PROJECT_BINARY_DIR}/verilated/${library}/${name}.cpp)
  file(CONFIGURE OUTPUT ${unit} CONTENT "${text}" @ONLY)
  set_source_files_properties(${files} PROPERTIES HEADER_FILE_ONLY ON)
  set_source_files_properties(${unit} PROPERTIES COMPILE_OPTIONS "${options}")
  target_sources(${library} PRIVATE ${unit})
endfunction()

# The library of this name and folder in the build TRAMMEL_BASE.
function(trammel_imported_library name)
  file(RELATIVE_PATH folder ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR})
  add_library(${name} STATIC IMPORTED GLOBAL)
  set_target_properties(${name} PROPERTIES
    IMPORTED_LOCATION ${TRAMMEL_BASE}/${folder}/lib${name}.a)
endfunction()

if(TRAMMEL_BASE)
  find_package(Threads REQUIRED)
  function(verilate target)
    cmake_parse_arguments(MODEL "" "DIRECTORY" "" ${ARGN})
    string(REPLACE ${PROJECT_BINARY_DIR} ${TRAMMEL_BASE} folder ${MODEL_DIRECTORY})
    target_include_directories(${target} INTERFACE ${folder})
  endfunction()
endif()

# The model of a block for its unit test: assertions live, coverage counted. A chip or board carries
# the properties of all blocks; what its blocks have of coverage they get in their own tests. A line
# `// verilate: ARGS` in the test sets parameters of the module.
function(trammel_unit_model source test)
  cmake_path(GET source STEM block)
  cmake_path(GET source PARENT_PATH folder)
  cmake_path(GET folder FILENAME layer)
  if(layer STREQUAL chips OR folder MATCHES "^rtl/boards/")
    set(properties ${TRAMMEL_RTL_PROPERTIES})
    set(first ${PROJECT_BINARY_DIR}/chips_only.vlt)
  else()
    file(GLOB properties CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/${block}_props.sv)
  endif()
  file(STRINGS ${test} parameters REGEX "^// verilate: ")
  string(REPLACE "// verilate: " "" parameters "${parameters}")
  separate_arguments(parameters)
  trammel_verilate(trammel_rtl ${block} "" COVERAGE TOP_MODULE ${block} PREFIX V${block}
    SOURCES ${first} ${TRAMMEL_RTL_PACKAGES} ${PROJECT_SOURCE_DIR}/${source} ${properties}
    DIRECTORY ${PROJECT_BINARY_DIR}/verilated
    VERILATOR_ARGS -Wno-fatal --assert -fno-split ${parameters} ${TRAMMEL_RTL_SEARCH})
endfunction()

# rtl/<layer>/<block>.sv with tests/<layer>/<block>_test.cpp: lint test, verilated model, unit test;
# a long test has parts, <block>_<part>_test.cpp.
# The unit tests leave their counts of coverage for the test coverage.rtl; those of a build with
# TRAMMEL_BASE do not, as when they are run by hand.
function(trammel_add_blocks)
  file(GLOB rtl CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/rtl/*/*.sv)
  list(FILTER rtl EXCLUDE REGEX "_(pkg|props)\\.sv$|^rtl/boards/")
  set(off ${TRAMMEL_RTL_DIRS})
  list(FILTER off EXCLUDE REGEX "/chips$")
  list(TRANSFORM off REPLACE "^.*/rtl/(.*)$" "coverage_off -file \"*/rtl/\\1/*\"\n")
  string(CONCAT off "`verilator_config\n" ${off} "coverage_off -file \"*/generated/*\"\n")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/chips_only.vlt CONTENT "${off}" @ONLY)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/coverage/rtl)
  if(TRAMMEL_ONLY)
    list(FILTER rtl INCLUDE REGEX "/(${TRAMMEL_ONLY})\\.sv$")
  endif()
  foreach(source IN LISTS rtl)
    cmake_path(GET source STEM block)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME layer)
    add_test(NAME lint.${layer}.${block}
      COMMAND ${PROJECT_SOURCE_DIR}/scripts/lint.py ${layer}/${block})
    set_tests_properties(lint.${layer}.${block} PROPERTIES SKIP_RETURN_CODE 77)
    if(EXISTS ${PROJECT_SOURCE_DIR}/rtl/${layer}/${block}_props.sv)
      add_test(NAME formal.${layer}.${block}
        COMMAND ${PROJECT_SOURCE_DIR}/scripts/prove.py ${layer}/${block})
      set_tests_properties(formal.${layer}.${block} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
    endif()
    if(EXISTS ${PROJECT_SOURCE_DIR}/rtl/${layer}/${block}_leap.toml)
      set(leap ${PROJECT_SOURCE_DIR}/scripts/prove.py --leap)
      add_test(NAME formal.leap.${block} COMMAND ${leap} ${layer}/${block})
      add_test(NAME formal.leap.broken.${block} COMMAND ${leap} --broken ${layer}/${block})
      set_tests_properties(formal.leap.${block} formal.leap.broken.${block} PROPERTIES
        SKIP_RETURN_CODE 77 TIMEOUT 1200)
    endif()
    set(test ${PROJECT_SOURCE_DIR}/tests/${layer}/${block}_test.cpp)
    if(EXISTS ${test})
      trammel_unit_model(${source} ${test})
      trammel_test(${block}_test ${test} unit.${layer}.${block} trammel_rtl trammel_models)
      file(GLOB parts CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/${layer}/${block}_*_test.cpp)
      target_sources(${block}_test PRIVATE ${parts})
      if(NOT TRAMMEL_BASE)
        set_tests_properties(unit.${layer}.${block} PROPERTIES FIXTURES_SETUP rtl_coverage
          ENVIRONMENT TRAMMEL_COVERAGE=${PROJECT_BINARY_DIR}/coverage/rtl/${layer}.${block}.dat)
      endif()
    endif()
  endforeach()
endfunction()

# rtl/boards/<board>/<top>.sv with tests/boards/<top>_test.cpp.
function(trammel_add_boards)
  file(GLOB tests CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tests/boards/*_test.cpp)
  foreach(test IN LISTS tests)
    cmake_path(GET test STEM name)
    string(REGEX REPLACE "_test$" "" top ${name})
    file(GLOB source RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/rtl/boards/*/${top}.sv)
    trammel_unit_model(${source} ${test})
    trammel_test(${name} ${test} unit.boards.${top} trammel_rtl trammel_models)
  endforeach()
endfunction()
