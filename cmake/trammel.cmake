# One helper per kind of thing; sources are found by folder, nothing is listed by hand.

file(GLOB TRAMMEL_RTL_DIRS LIST_DIRECTORIES true CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*)
list(FILTER TRAMMEL_RTL_DIRS EXCLUDE REGEX "/boards$")
set(TRAMMEL_RTL_SEARCH ${TRAMMEL_RTL_DIRS})
list(TRANSFORM TRAMMEL_RTL_SEARCH PREPEND -I)
list(APPEND TRAMMEL_RTL_SEARCH -I${PROJECT_SOURCE_DIR}/rtl/chips/generated)
file(GLOB TRAMMEL_RTL_PACKAGES CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/rtl/pkg/*_pkg.sv ${PROJECT_SOURCE_DIR}/rtl/math/*_pkg.sv
  ${PROJECT_SOURCE_DIR}/rtl/chips/generated/*_pkg.sv)
file(GLOB chip_packages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/chips/*_pkg.sv)
list(APPEND TRAMMEL_RTL_PACKAGES ${chip_packages})  # they use the others
file(GLOB TRAMMEL_RTL_PROPERTIES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/rtl/*/*_props.sv)
list(FILTER TRAMMEL_RTL_PROPERTIES EXCLUDE REGEX "/boards/")

# RTL of processor cores that packages of .venv bring; empty where these are missing.
set(packages ${PROJECT_SOURCE_DIR}/.venv/lib/python3*/site-packages)
file(GLOB TRAMMEL_PICORV32 CONFIGURE_DEPENDS
  ${packages}/pythondata_cpu_picorv32/verilog/picorv32.v)
file(GLOB TRAMMEL_VEXRISCV CONFIGURE_DEPENDS
  ${packages}/pythondata_cpu_vexriscv/verilog/VexRiscv_Lite.v)

# A library of all .cpp files of a folder tree (header-only: an INTERFACE library).
function(trammel_library name folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${folder}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "/verilated/|/rv32im/")  # see cosim/, scripts/tool firmware
  if(sources)
    add_library(${name} STATIC ${sources})
    target_link_libraries(${name} PUBLIC trammel_options ${ARGN})
    trammel_unity_if_checked(${name})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE trammel_options ${ARGN})
  endif()
endfunction()

# With checks and counters the templates of a header library compile slowly: one unit per folder.
function(trammel_unity_if_checked name)
  if(TRAMMEL_BASE)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
endfunction()

# Headers of other libraries, which most units of a library include, are compiled once, or taken
# from another library with the same options. A unit names the headers that it uses all the same:
# the build with checks compiles them one by one.
#   trammel_precompile(library [owner | HEADERS ...])
function(trammel_precompile library)
  if(TRAMMEL_BASE)
    return()
  endif()
  cmake_parse_arguments(PRECOMPILE "" "" HEADERS ${ARGN})
  target_compile_options(${library} PRIVATE -fpch-preprocess)  # for ccache
  if(PRECOMPILE_HEADERS)
    target_precompile_headers(${library} PRIVATE ${PRECOMPILE_HEADERS})
  elseif(ARGN)
    target_precompile_headers(${library} REUSE_FROM ${ARGN})
  else()
    target_precompile_headers(${library} PRIVATE <algorithm> <cmath> <cstdint> <filesystem>
      <functional> <memory> <optional> <string> <variant> <vector> <fmt/format.h>
      <nlohmann/json.hpp>)
  endif()
endfunction()

# An executable of Catch2 cases from one file or a list of files; the test has the name `prefix`,
# unit.<group>.<name>. With checks, tests of a group that are linked with machines are one program,
# since linking takes longest. checked_<group> builds what `scripts/tool sanitize <group>` runs.
function(trammel_test name source prefix)
  string(REGEX REPLACE "^unit\\.([^.]+)\\..*" "\\1" group ${prefix})
  set(command ${name})
  if(TRAMMEL_BASE AND "${ARGN}" MATCHES "test_")
    set(name ${group}_tests)
    cmake_path(GET source STEM stem)
    set(command ${name} --filenames-as-tags "[#${stem}]" --warn NoTests)
  endif()
  if(TARGET ${name})
    target_sources(${name} PRIVATE ${source})
  else()
    trammel_test_program(${name} "${source}" ${ARGN})
  endif()
  trammel_checked(${group} ${name})
  add_test(NAME ${prefix} COMMAND ${command})
  set_tests_properties(${prefix} PROPERTIES TIMEOUT 300)
endfunction()

function(trammel_checked group)
  if(TRAMMEL_BASE)
    if(NOT TARGET checked_${group})
      add_custom_target(checked_${group})
    endif()
    add_dependencies(checked_${group} ${ARGN})
  endif()
endfunction()

function(trammel_test_program name source)
  add_executable(${name} ${source})
  target_link_libraries(${name} PRIVATE trammel_options trammel_catch_main ${ARGN})
  trammel_precompile(${name} trammel_test_headers)
endfunction()

# Tests belong to the first tier, `trammel test`, except those named here: they belong to the rest,
# `trammel test --full-only` (docs/verification.md).
function(trammel_full_tier)
  set_property(TEST ${ARGN} PROPERTY LABELS full)
endfunction()

# A test whose result is kept (scripts/tool evidence): its command runs only where that no
# longer holds. trammel_evidence() adds one to the full tier.
function(trammel_kept name)
  add_test(NAME ${name}
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool evidence ${name} -- ${ARGN})
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 77)
endfunction()

function(trammel_evidence name)
  trammel_kept(${name} ${ARGN})
  trammel_full_tier(${name})
endfunction()

# A whole campaign, which may take hours (`trammel test --campaign`). CTest knows it only with
# `-C campaign`, so that no choice by name starts it.
function(trammel_campaign name)
  trammel_kept(${name} ${ARGN} CONFIGURATIONS campaign)
  set_tests_properties(${name} PROPERTIES LABELS campaign PROCESSORS 2 TIMEOUT 86400)
endfunction()

# Programs that only tests of the full tier need; the target trammel_full builds them.
function(trammel_full_programs)
  set_target_properties(${ARGN} PROPERTIES EXCLUDE_FROM_ALL ON)
  add_dependencies(trammel_full ${ARGN})
endfunction()

# A library of verilated models. Their headers are not ours: no warnings from them. With
# TRAMMEL_BASE it is that of another build of these sources, and nothing is verilated.
function(trammel_verilated_library name)
  if(TRAMMEL_BASE)
    trammel_imported_library(${name})
  else()
    add_library(${name} STATIC)
    target_include_directories(${name} PRIVATE ${VERILATOR_ROOT}/include
      ${VERILATOR_ROOT}/include/vltstd)
  endif()
  target_include_directories(${name} INTERFACE ${VERILATOR_ROOT}/include
    ${VERILATOR_ROOT}/include/vltstd)
  target_link_libraries(${name} INTERFACE z Threads::Threads)
  set_property(TARGET ${name} PROPERTY INTERFACE_SYSTEM_INCLUDE_DIRECTORIES
    $<TARGET_PROPERTY:${name},INTERFACE_INCLUDE_DIRECTORIES>)
endfunction()

# Verilator's runtime, with the given parts of it: cov, dpi, fst_c.
function(trammel_verilator_runtime library)
  if(NOT TRAMMEL_BASE)
    set(parts ${ARGN})
    list(TRANSFORM parts REPLACE "(.+)" "${VERILATOR_ROOT}/include/verilated_\\1.cpp")
    target_sources(${library} PRIVATE ${VERILATOR_ROOT}/include/verilated.cpp
      ${VERILATOR_ROOT}/include/verilated_threads.cpp ${parts})
  endif()
endfunction()

# A model as one unit of a library, <name>.cpp in build/verilated/<name>, compiled with these
# options: many small units would take twice as long. It is verilated when it is built, so that a
# block can be built alone.
function(trammel_verilate library name options)
  cmake_parse_arguments(MODEL "COVERAGE;TRACE_FST" "TOP_MODULE;PREFIX" "SOURCES;VERILATOR_ARGS"
    ${ARGN})
  set(folder verilated/${name})
  if(TRAMMEL_BASE)
    target_include_directories(${library} INTERFACE ${TRAMMEL_BASE}/${folder})
    return()
  endif()
  set(folder ${PROJECT_BINARY_DIR}/${folder})
  set(unit ${folder}/${name}.cpp)
  set(command ${VERILATOR_BIN} --cc --top ${MODEL_TOP_MODULE})
  if(MODEL_COVERAGE)
    list(APPEND command --coverage)
    target_compile_definitions(${library} PRIVATE VM_COVERAGE=1)
  endif()
  if(MODEL_TRACE_FST)
    list(APPEND command --trace-fst)
    target_compile_definitions(${library} PRIVATE VM_TRACE=1 VM_TRACE_FST=1)
    set(keep ${MODEL_PREFIX}__Trace__0.cpp)  # scripts/tool gen-wave-timers reads it
  endif()
  list(APPEND command ${MODEL_VERILATOR_ARGS} ${MODEL_SOURCES})
  string(REPLACE "${PROJECT_SOURCE_DIR}/" "" command "${command}")
  set(kept ${MODEL_PREFIX}.h ${MODEL_PREFIX}___024root.h ${MODEL_PREFIX}__Syms.h ${keep})
  list(TRANSFORM kept PREPEND ${folder}/)
  add_custom_command(OUTPUT ${unit} BYPRODUCTS ${kept}
    COMMAND ${CMAKE_COMMAND} -DUNIT=${unit} -DPREFIX=${MODEL_PREFIX} -DKEEP=${keep}
      -DSOURCE=${PROJECT_SOURCE_DIR} -P ${PROJECT_SOURCE_DIR}/cmake/verilate.cmake -- ${command}
    DEPENDS ${MODEL_SOURCES} ${PROJECT_SOURCE_DIR}/cmake/verilate.cmake
    DEPFILE ${unit}.d COMMENT "Verilating ${name}" VERBATIM)
  set_source_files_properties(${unit} PROPERTIES COMPILE_OPTIONS "${options}")
  target_sources(${library} PRIVATE ${unit})
  target_include_directories(${library} PUBLIC ${folder})
endfunction()

# The library of this name and folder in the build TRAMMEL_BASE.
function(trammel_imported_library name)
  file(RELATIVE_PATH folder ${PROJECT_BINARY_DIR} ${CMAKE_CURRENT_BINARY_DIR})
  add_library(${name} STATIC IMPORTED GLOBAL)
  set_target_properties(${name} PROPERTIES
    IMPORTED_LOCATION ${TRAMMEL_BASE}/${folder}/lib${name}.a)
endfunction()

# The model of a block for its unit test, a library of that name: assertions enabled, coverage
# counted on request. With -Og it compiles in half the time of -O1 and runs a sixth slower. A chip
# or board includes the properties of all blocks; the coverage of its blocks is counted in their own
# tests. A line `// verilate: ARGS` in the test sets parameters of the module. A vendor's cells on a
# board have models in tests/boards/cells.
function(trammel_unit_model library source test)
  cmake_path(GET source STEM block)
  cmake_path(GET source PARENT_PATH folder)
  cmake_path(GET folder FILENAME layer)
  if(layer STREQUAL chips OR folder MATCHES "^rtl/boards/")
    set(properties ${TRAMMEL_RTL_PROPERTIES})
    set(first ${PROJECT_BINARY_DIR}/chips_only.vlt)
    if(NOT layer STREQUAL chips)
      set(cells -I${PROJECT_SOURCE_DIR}/tests/boards/cells)
    endif()
  else()
    file(GLOB properties CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${folder}/${block}_props.sv)
  endif()
  file(STRINGS ${test} parameters REGEX "^// verilate: ")
  string(REPLACE "// verilate: " "" parameters "${parameters}")
  separate_arguments(parameters)
  trammel_verilated_library(${library})
  target_link_libraries(${library} INTERFACE trammel_rtl_runtime)
  trammel_verilate(${library} ${library} -Og ${ARGN} TOP_MODULE ${block} PREFIX V${block}
    SOURCES ${first} ${TRAMMEL_RTL_PACKAGES} ${PROJECT_SOURCE_DIR}/${source} ${properties}
    VERILATOR_ARGS -Wno-fatal --assert -fno-split ${parameters} ${TRAMMEL_RTL_SEARCH} ${cells})
endfunction()

# A long test has parts, <block>_<part>_test.cpp, where <block>_<part> is no block of its own.
function(trammel_test_parts out block source folder)
  cmake_path(GET source PARENT_PATH rtl)
  file(GLOB parts CONFIGURE_DEPENDS ${folder}/${block}_*_test.cpp)
  foreach(part IN LISTS parts)
    cmake_path(GET part STEM name)
    string(REGEX REPLACE "_test$" "" name ${name})
    if(EXISTS ${PROJECT_SOURCE_DIR}/${rtl}/${name}.sv)
      list(REMOVE_ITEM parts ${part})
    endif()
  endforeach()
  set(${out} ${parts} PARENT_SCOPE)
endfunction()

# The unit test <block>_test of a block or board with its model.
function(trammel_unit_test block source test prefix)
  cmake_path(GET test PARENT_PATH folder)
  trammel_test_parts(parts ${block} ${source} ${folder})
  trammel_unit_model(rtl_${block} ${source} ${test})
  trammel_test(${block}_test "${test};${parts}" unit.${prefix} rtl_${block} trammel_models)
endfunction()

# The unit test once more, with a model that counts coverage. That takes five times as long to
# compile, so it belongs to the full tier. Its counts are for the test coverage.rtl.
function(trammel_coverage_test block source test prefix)
  cmake_path(GET test PARENT_PATH folder)
  trammel_test_parts(parts ${block} ${source} ${folder})
  set(name ${block}_coverage)
  trammel_unit_model(rtl_${name} ${source} ${test} COVERAGE)
  trammel_test_program(${name} "${test};${parts}" rtl_${name} trammel_models)
  target_compile_definitions(${name} PRIVATE TRAMMEL_COVERAGE)
  set_target_properties(rtl_${name} ${name} PROPERTIES EXCLUDE_FROM_ALL ON)
  trammel_evidence(coverage.${prefix} ${PROJECT_SOURCE_DIR}/scripts/tool coverage
    --count ${layer}/${block} --program $<TARGET_FILE:${name}>)
  set_tests_properties(coverage.${prefix} PROPERTIES TIMEOUT 600 FIXTURES_SETUP rtl_coverage)
endfunction()

# Lint test and proofs of the block <layer>/<block> in this folder.
function(trammel_block_checks layer block folder)
  set(prefix ${layer}.${block})
  add_test(NAME lint.${prefix}
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool lint ${layer}/${block})
  set_tests_properties(lint.${prefix} PROPERTIES SKIP_RETURN_CODE 77)
  if(EXISTS ${folder}/${block}_props.sv)
    trammel_evidence(formal.${prefix} ${PROJECT_SOURCE_DIR}/scripts/tool prove ${layer}/${block})
    set_tests_properties(formal.${prefix} PROPERTIES TIMEOUT 600)
  endif()
endfunction()

# rtl/<layer>/<block>.sv with tests/<layer>/<block>_test.cpp: lint test, proofs, unit test.
function(trammel_add_blocks)
  file(GLOB rtl CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/rtl/*/*.sv)
  list(FILTER rtl EXCLUDE REGEX "_(pkg|props)\\.sv$|^rtl/boards/")
  set(off ${TRAMMEL_RTL_DIRS})
  list(FILTER off EXCLUDE REGEX "/chips$")
  list(TRANSFORM off REPLACE "^.*/rtl/(.*)$" "coverage_off -file \"*rtl/\\1/*\"\n")
  string(CONCAT off "`verilator_config\n" ${off} "coverage_off -file \"*/generated/*\"\n")
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/chips_only.vlt CONTENT "${off}" @ONLY)
  file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/coverage/rtl)
  foreach(source IN LISTS rtl)
    cmake_path(GET source STEM block)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(GET folder FILENAME layer)
    set(prefix ${layer}.${block})
    trammel_block_checks(${layer} ${block} ${PROJECT_SOURCE_DIR}/rtl/${layer})
    if(EXISTS ${PROJECT_SOURCE_DIR}/rtl/${layer}/${block}_leap.toml)
      set(leap ${PROJECT_SOURCE_DIR}/scripts/tool prove --leap)
      trammel_evidence(formal.leap.${block} ${leap} ${layer}/${block})
      trammel_evidence(formal.leap.broken.${block} ${leap} --broken ${layer}/${block})
      set_tests_properties(formal.leap.${block} formal.leap.broken.${block} PROPERTIES
        TIMEOUT 1200 COST 500)
    endif()
    set(test ${PROJECT_SOURCE_DIR}/tests/${layer}/${block}_test.cpp)
    # A module of a chip has assertions and is tested in the chip.
    set(props ${PROJECT_SOURCE_DIR}/rtl/chips/${block}_props.sv)
    if(NOT TRAMMEL_BASE AND (EXISTS ${test} OR EXISTS ${props}))
      trammel_campaign(campaign.mutants.${prefix}
        ${PROJECT_SOURCE_DIR}/scripts/tool verify --mutants ${layer}/${block})
    endif()
    if(EXISTS ${test})
      trammel_unit_test(${block} ${source} ${test} ${prefix})
      if(NOT TRAMMEL_BASE)
        trammel_coverage_test(${block} ${source} ${test} ${prefix})
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
    trammel_unit_test(${top} ${source} ${test} boards.${top})
  endforeach()
endfunction()

# A unit that collects what a function of each of these machines returns, in the folder `table`; its
# path in `out`.
#   trammel_machine_table(out table machine "const lab::Machine&" NAMES...)
function(trammel_machine_table out table function result)
  set(declared)
  set(called)
  foreach(machine IN LISTS ARGN)
    string(APPEND declared "namespace ${machine} { ${result} ${function}(); }\n")
    string(APPEND called "    add(${machine}::${function}());\n")
  endforeach()
  string(TOLOWER "${function}" stem)
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/${table}/${stem}_table.cpp)
  set(TABLE_DECLARED "${declared}")
  set(TABLE_CALLED "${called}")
  configure_file(${PROJECT_SOURCE_DIR}/cmake/${stem}_table.cpp.in ${unit} @ONLY)
  set(${out} ${unit} PARENT_SCOPE)
endfunction()

# links.txt, for scripts/tool check-layout: every target with its room, which is its folder unless
# TRAMMEL_ROOM names it, and the targets that it links.
function(trammel_write_links)
  trammel_links_of(${PROJECT_SOURCE_DIR} lines)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/links.txt CONTENT "${lines}" @ONLY)
endfunction()

function(trammel_links_of folder out)
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  cmake_path(RELATIVE_PATH folder BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE room)
  string(REGEX REPLACE "^(.*/tests/.*|.*/tests)$" "tests" room ${room})
  string(REGEX REPLACE "/.*" "" room ${room})
  set(lines)
  foreach(target IN LISTS targets)
    get_target_property(own ${target} TRAMMEL_ROOM)
    if(NOT own)
      set(own ${room})
    endif()
    set(line ${own} ${target})
    foreach(property IN ITEMS LINK_LIBRARIES INTERFACE_LINK_LIBRARIES SOURCES INTERFACE_SOURCES)
      get_target_property(linked ${target} ${property})
      list(FILTER linked INCLUDE REGEX "^[a-z0-9_]+$|^\\$<(TARGET_OBJECTS|LINK_ONLY):")
      list(TRANSFORM linked REPLACE "^\\$<[A-Z_]+:(.*)>$" "\\1")
      list(APPEND line ${linked})
    endforeach()
    list(JOIN line " " line)
    string(APPEND lines "${line}\n")
  endforeach()
  get_property(folders DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(inner IN LISTS folders)
    trammel_links_of(${inner} more)
    string(APPEND lines "${more}")
  endforeach()
  set(${out} "${lines}" PARENT_SCOPE)
endfunction()
