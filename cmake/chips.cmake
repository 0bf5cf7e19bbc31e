# The verilated chips of machines and parts: a folder with verilated/ has a chip.cmake that names
# its chip by trammel_chip(), which alone makes the models and what goes with them.

# From rtl/chips/<chip>.sv, or rtl/<chip>.sv in the calling folder: V<chip>_fast, for speed;
# V<chip>_fst, with an FST writer (5.006 builds one format per model), which is evaluated only in
# windows of waves; and V<chip>_checked, with the properties of all blocks, for `run --assert`,
# since they would double the cost of an evaluation. These two are optimised less: they compile in
# a third of the time. It is integer code, so it alone may use all instructions of this computer.
# Also the headers <chip>_state.hpp and <chip>_watched.hpp, the registers and inputs of the
# models for `run --audit` and waves, and <chip>_traced.hpp, the signals that change in every
# clock of the waves.
#
# The unit with make_verilated_chip() goes to the library chips_<folder>: it makes the fast model of
# a plain run. The models of runs with waves, assertions or an audit are made by the objects
# watched_<folder>; a program of plain runs has plain_<folder> in their place, which throws
# cosim::NotBuilt.
# The chip's files, chip.hpp and verilated/, are in the calling folder or in a folder of it.
#   INTERFACE name    the class by which the loop knows the chip, in the namespace of the calling
#                     folder; its verilated/chip_model.hpp has the template ChipModel<Model, Tracer>
#   VISIBLE FILE...   .vlt files with the signals that C++ reads; default: verilated/*.vlt there
#   TRACE_ARRAYS N    memories up to this size are in the waves
#   KIND word         other models of a chip that has them already, V<chip>_<word>_fast and so on
#   PARAMETERS A=N... of the RTL
#   FUNCTION name     in place of make_verilated_chip()
#   SETUP type        what it also takes, const, and gives to the constructor of ChipModel
macro(trammel_chip chip)
  cmake_parse_arguments(CHIP "" "INTERFACE;TRACE_ARRAYS;KIND;FUNCTION;SETUP" "VISIBLE;PARAMETERS"
    ${ARGN})
  set(CHIP_FOLDER ${CMAKE_CURRENT_LIST_DIR})
  set(CHIP_MODEL ${chip})
  set(CHIP_STEM ${chip})  # the generators take the name of the chip from what is before a -
  if(CHIP_KIND)
    string(APPEND CHIP_MODEL _${CHIP_KIND})
    string(APPEND CHIP_STEM -${CHIP_KIND})
  endif()
  trammel_chip_models_of(${chip})
  trammel_chip_headers_of(${chip})
  trammel_chip_unit_of(${chip})
endmacro()

# A file of the chip, as code includes it.
function(trammel_chip_file variable name)
  file(GLOB found CONFIGURE_DEPENDS RELATIVE ${PROJECT_SOURCE_DIR}
    ${CHIP_FOLDER}/${name} ${CHIP_FOLDER}/*/${name})
  list(LENGTH found number)
  if(NOT number EQUAL 1)
    message(FATAL_ERROR "${CHIP_FOLDER}: has ${number} files ${name}, must have one")
  endif()
  set(${variable} ${found} PARENT_SCOPE)
endfunction()

function(trammel_chip_unit_of chip)
  cmake_path(GET CHIP_FOLDER FILENAME CHIP_NAMESPACE)
  trammel_chip_file(CHIP_PUBLIC chip.hpp)
  trammel_chip_file(CHIP_HEADER verilated/chip_model.hpp)
  string(REGEX REPLACE "[-_]" ";" words ${CHIP_STEM})
  set(camel)
  foreach(word IN LISTS words)
    string(SUBSTRING ${word} 0 1 first)
    string(SUBSTRING ${word} 1 -1 rest)
    string(TOUPPER ${first} first)
    string(APPEND camel ${first}${rest})
  endforeach()
  if(NOT CHIP_FUNCTION)
    set(CHIP_FUNCTION make_verilated_chip)
  endif()
  set(CHIP_TAKES)
  set(CHIP_TAKEN)
  set(CHIP_GIVES)
  if(CHIP_SETUP)
    set(CHIP_TAKES ", const ${CHIP_SETUP}& setup")
    set(CHIP_TAKEN ", const ${CHIP_SETUP}&")
    set(CHIP_GIVES ", setup")
  endif()
  foreach(kind chip watched plain)
    set(unit ${CMAKE_CURRENT_BINARY_DIR}/${CHIP_MODEL}/${kind}.cpp)
    configure_file(${PROJECT_SOURCE_DIR}/cmake/${kind}_unit.cpp.in ${unit} @ONLY)
    set(${kind}_units ${${kind}_units} ${unit} PARENT_SCOPE)
  endforeach()
endfunction()

function(trammel_chip_model library chip kind opt)
  cmake_parse_arguments(MODEL "TRACE_FST" "" "SOURCES;ARGS" ${ARGN})
  set(trace)
  if(MODEL_TRACE_FST)
    set(trace TRACE_FST)
  endif()
  set(source ${PROJECT_SOURCE_DIR}/rtl/chips/${chip}.sv)
  set(search ${TRAMMEL_RTL_SEARCH})
  if(EXISTS ${CHIP_FOLDER}/rtl)
    set(source ${CHIP_FOLDER}/rtl/${chip}.sv)
    list(APPEND search -I${CHIP_FOLDER}/rtl)
  endif()
  set(parameters ${CHIP_PARAMETERS})
  list(TRANSFORM parameters PREPEND -G)
  trammel_verilate(${library} ${CHIP_MODEL}_${kind}
    "${opt};-march=${TRAMMEL_MARCH}" ${trace} TOP_MODULE ${chip} PREFIX V${CHIP_MODEL}_${kind}
    SOURCES ${CHIP_VISIBLE} ${TRAMMEL_RTL_PACKAGES} ${source} ${MODEL_SOURCES}
    VERILATOR_ARGS -Wno-fatal -O3 --x-assign fast --x-initial unique ${search}
      ${parameters} ${MODEL_ARGS})
endfunction()

function(trammel_chip_models_of chip)
  if(NOT CHIP_VISIBLE)
    file(GLOB CHIP_VISIBLE CONFIGURE_DEPENDS ${CHIP_FOLDER}/verilated/*.vlt
      ${CHIP_FOLDER}/*/verilated/*.vlt)
  endif()
  set(arrays)
  if(CHIP_TRACE_ARRAYS)
    set(arrays --trace-max-array ${CHIP_TRACE_ARRAYS})
  endif()
  set(fast model_${CHIP_MODEL})
  set(watched watched_model_${CHIP_MODEL})
  foreach(library ${fast} ${watched})
    trammel_verilated_library(${library})
  endforeach()
  target_link_libraries(${fast} INTERFACE trammel_verilator)
  target_link_libraries(${watched} INTERFACE trammel_verilator_fst)
  # Partial redundancies moved into all paths cost the generated code 4 % of its speed, neighbouring
  # members gathered in vectors 3 %.
  trammel_chip_model(${fast} ${chip} fast
    "-O3;-fno-tree-pre;-fno-tree-slp-vectorize;-falign-functions=64")
  trammel_chip_model(${watched} ${chip} fst -Og TRACE_FST ARGS ${arrays})
  file(GLOB properties CONFIGURE_DEPENDS ${CHIP_FOLDER}/rtl/*_props.sv)
  trammel_chip_model(${watched} ${chip} checked -Og
    SOURCES ${TRAMMEL_RTL_PROPERTIES} ${properties} ARGS --assert)
  set(chip_models ${chip_models} ${fast} PARENT_SCOPE)
  set(watched_models ${watched_models} ${watched} PARENT_SCOPE)
endfunction()

function(trammel_chip_headers_of chip)
  set(stem ${registers}/${CHIP_STEM})
  set(chip_headers ${chip_headers} ${stem}_state.hpp PARENT_SCOPE)
  set(watched_headers ${watched_headers} ${stem}_state.hpp ${stem}_watched.hpp
    ${stem}_traced.hpp PARENT_SCOPE)
  if(TRAMMEL_BASE)
    return()
  endif()
  set(models ${PROJECT_BINARY_DIR}/verilated)
  foreach(kind fast fst checked)
    set(${kind} ${models}/${CHIP_MODEL}_${kind}/V${CHIP_MODEL}_${kind}___024root.h)
  endforeach()
  set(generate ${PROJECT_SOURCE_DIR}/scripts/trammel_tools/generate)
  set(traced ${models}/${CHIP_MODEL}_fst/V${CHIP_MODEL}_fst__Trace__0.cpp)
  trammel_gen_model_state(${stem}_state.hpp ${fast})
  trammel_gen_model_state(${stem}_watched.hpp ${fast} ${fst} ${checked})
  add_custom_command(OUTPUT ${stem}_traced.hpp
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool gen-wave-timers ${traced} ${stem}_traced.hpp
    DEPENDS ${generate}/gen_wave_timers.py ${traced})
endfunction()

# In a chip.cmake: the machine is made with this part of parts/.
macro(trammel_with_part part)
  list(APPEND folder_parts ${part})
endmacro()

# The header that scripts/tool gen-model-state writes of these roots of models.
function(trammel_gen_model_state header)
  set(generate ${PROJECT_SOURCE_DIR}/scripts/trammel_tools/generate)
  add_custom_command(OUTPUT ${header}
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool gen-model-state ${header} ${ARGN} ${chip_rtl}
    DEPENDS ${generate}/gen_model_state.py ${generate}/model_regions.py ${ARGN} ${chip_rtl})
endfunction()

# The libraries of a folder's chips and of its units in verilated/: chips_<folder>, and the objects
# watched_<folder> and plain_<folder>.
function(trammel_chips_of folder)
  cmake_path(GET folder FILENAME name)
  file(GLOB units CONFIGURE_DEPENDS ${folder}/verilated/*.cpp ${folder}/*/verilated/*.cpp)
  # They see inline code of the models, which is compiled for this computer.
  set(options -march=${TRAMMEL_MARCH} -fno-tree-slp-vectorize -falign-functions=64
    -falign-jumps=32)
  set_source_files_properties(${chip_units} ${watched_units} PROPERTIES
    COMPILE_OPTIONS "${options}")
  if(TRAMMEL_FUZZ)  # no fuzzer reaches a chip
    trammel_imported_library(chips_${name})
    target_link_libraries(chips_${name} INTERFACE ${chip_models} trammel_models)
  else()
    add_library(chips_${name} STATIC ${units} ${chip_units} ${chip_headers})
    target_include_directories(chips_${name} PRIVATE ${registers})
    target_link_libraries(chips_${name} PUBLIC trammel_options trammel_cosim
      PRIVATE ${chip_models} trammel_models)
    add_library(watched_${name} OBJECT ${watched_units} ${watched_headers})
    target_include_directories(watched_${name} PRIVATE ${registers})
    target_link_libraries(watched_${name} PUBLIC trammel_options trammel_cosim ${chip_models}
      ${watched_models} trammel_models)
  endif()
  add_library(plain_${name} OBJECT ${plain_units})
  target_link_libraries(plain_${name} PUBLIC trammel_options trammel_cosim)
endfunction()
