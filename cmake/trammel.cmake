# One helper per kind of thing; sources are found by folder, nothing is listed by hand.

file(GLOB TRAMMEL_RTL_DIRS LIST_DIRECTORIES true CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*)
list(FILTER TRAMMEL_RTL_DIRS EXCLUDE REGEX "/boards$")
set(TRAMMEL_RTL_SEARCH ${TRAMMEL_RTL_DIRS})
list(TRANSFORM TRAMMEL_RTL_SEARCH PREPEND -I)
list(APPEND TRAMMEL_RTL_SEARCH -I${PROJECT_SOURCE_DIR}/rtl/chips/generated)
file(GLOB TRAMMEL_RTL_PACKAGES CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/rtl/pkg/*_pkg.sv ${PROJECT_SOURCE_DIR}/rtl/math/*_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/chips/generated/*_pkg.sv)

# A library of all .cpp files of a folder tree (header-only: an INTERFACE library).
function(trammel_library name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/verilated/")  # units of verilated models: see cosim/
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC trammel_options ${ARGN})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE trammel_options ${ARGN})
  endif()
endfunction()

# An executable of Catch2 cases; every case becomes a test named <prefix>.<case>.
function(trammel_test name source prefix)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE trammel_options trammel_catch_main ${ARGN})
  add_test(NAME ${prefix} COMMAND ${name})
  set_tests_properties(${prefix} PROPERTIES TIMEOUT 300)
endfunction()

# A library of verilated models. Their headers are not ours: no warnings from them.
function(trammel_verilated_library name)
  add_library(${name} STATIC ${ARGN})
  set_property(TARGET ${name} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES
    $<TARGET_PROPERTY:${name},INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# rtl/<layer>/<block>.sv with tests/<layer>/<block>_test.cpp: lint test, verilated model, unit test.
function(trammel_add_blocks)
  file(GLOB rtl CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/rtl/*/*.sv)
  list(FILTER rtl EXCLUDE REGEX "_(pkg|props)\\.sv$|^rtl/boards/")
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
    set(test ${PROJECT_SOURCE_DIR}/tests/${layer}/${block}_test.cpp)
    if(EXISTS ${test})
      if(NOT layer STREQUAL chips)  # chips are verilated once, in cosim/
        verilate(trammel_rtl SOURCES ${TRAMMEL_RTL_PACKAGES} ${PROJECT_SOURCE_DIR}/${source}
          TOP_MODULE ${block} PREFIX V${block} DIRECTORY ${PROJECT_BINARY_DIR}/verilated
          VERILATOR_ARGS -Wno-fatal ${TRAMMEL_RTL_SEARCH})
      endif()
      set(libraries trammel_rtl trammel_models)
      if(layer STREQUAL chips)
        list(APPEND libraries trammel_chip_models)
      endif()
      trammel_test(${block}_test ${test} unit.${layer}.${block} ${libraries})
    endif()
  endforeach()
endfunction()
