# The verilated chips of machines and parts: a folder with verilated/ has a chip.cmake that names
# its chip by trammel_chip(), which alone makes the models and what goes with them.

# From rtl/chips/<chip>.sv, in the library trammel_chip_models: V<chip>_fast, for speed;
# V<chip>_fst, with an FST writer (5.006 builds one format per model), which is evaluated only in
# windows of waves; and V<chip>_checked, with the properties of all blocks, for `run --assert`,
# since they would double the cost of an evaluation. These two are optimised less: they compile in
# a third of the time. It is integer code, so it alone may use all instructions of this computer.
# Also the headers <chip>_registers.hpp, the registers and inputs of the models for `run --audit`
# and waves, and <chip>_traced.hpp, the signals that change in every clock of the waves. And the
# unit with make_verilated_chip(), which makes the model that a run needs.
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

function(trammel_chip_unit_of chip)
  cmake_path(GET CHIP_FOLDER FILENAME CHIP_NAMESPACE)
  cmake_path(RELATIVE_PATH CHIP_FOLDER BASE_DIRECTORY ${PROJECT_SOURCE_DIR}
    OUTPUT_VARIABLE CHIP_HEADER)
  string(APPEND CHIP_HEADER /verilated/chip_model.hpp)
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
  set(CHIP_GIVES)
  if(CHIP_SETUP)
    set(CHIP_TAKES ", const ${CHIP_SETUP}& setup")
    set(CHIP_GIVES ", setup")
  endif()
  set(unit ${CMAKE_CURRENT_BINARY_DIR}/${CHIP_MODEL}/chips.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/chip_unit.cpp.in ${unit} @ONLY)
  set(chip_units ${chip_units} ${unit} PARENT_SCOPE)
endfunction()

function(trammel_chip_model chip kind opt)
  cmake_parse_arguments(MODEL "TRACE_FST" "" "SOURCES;ARGS" ${ARGN})
  set(trace)
  if(MODEL_TRACE_FST)
    set(trace TRACE_FST)
  endif()
  set(parameters ${CHIP_PARAMETERS})
  list(TRANSFORM parameters PREPEND -G)
  trammel_verilate(trammel_chip_models ${CHIP_MODEL}_${kind}
    "${opt};-march=${TRAMMEL_MARCH}" ${trace} TOP_MODULE ${chip} PREFIX V${CHIP_MODEL}_${kind}
    SOURCES ${CHIP_VISIBLE} ${TRAMMEL_RTL_PACKAGES} ${PROJECT_SOURCE_DIR}/rtl/chips/${chip}.sv
      ${MODEL_SOURCES}
    VERILATOR_ARGS -Wno-fatal -O3 --x-assign fast --x-initial unique ${TRAMMEL_RTL_SEARCH}
      ${parameters} ${MODEL_ARGS})
endfunction()

function(trammel_chip_models_of chip)
  if(NOT CHIP_VISIBLE)
    file(GLOB CHIP_VISIBLE CONFIGURE_DEPENDS ${CHIP_FOLDER}/verilated/*.vlt)
  endif()
  set(arrays)
  if(CHIP_TRACE_ARRAYS)
    set(arrays --trace-max-array ${CHIP_TRACE_ARRAYS})
  endif()
  # Partial redundancies moved into all paths cost the generated code 4 % of its speed, neighbouring
  # members gathered in vectors 3 %.
  trammel_chip_model(${chip} fast
    "-O3;-fno-tree-pre;-fno-tree-slp-vectorize;-falign-functions=64")
  trammel_chip_model(${chip} fst -Og TRACE_FST ARGS ${arrays})
  trammel_chip_model(${chip} checked -Og SOURCES ${TRAMMEL_RTL_PROPERTIES} ARGS --assert)
endfunction()

function(trammel_chip_headers_of chip)
  set(generated ${registers}/${CHIP_STEM}_registers.hpp ${registers}/${CHIP_STEM}_traced.hpp)
  set(chip_headers ${chip_headers} ${generated} PARENT_SCOPE)
  if(TRAMMEL_BASE)
    return()
  endif()
  set(models ${PROJECT_BINARY_DIR}/verilated)
  set(roots)
  foreach(kind fast fst checked)
    list(APPEND roots ${models}/${CHIP_MODEL}_${kind}/V${CHIP_MODEL}_${kind}___024root.h)
  endforeach()
  set(generate ${PROJECT_SOURCE_DIR}/scripts/trammel_tools/generate)
  set(traced ${models}/${CHIP_MODEL}_fst/V${CHIP_MODEL}_fst__Trace__0.cpp)
  add_custom_command(OUTPUT ${registers}/${CHIP_STEM}_registers.hpp
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool gen-registers ${registers}/${CHIP_STEM}_registers.hpp
      ${roots} ${chip_rtl}
    DEPENDS ${generate}/gen_registers.py ${generate}/model_regions.py ${roots} ${chip_rtl})
  add_custom_command(OUTPUT ${registers}/${CHIP_STEM}_traced.hpp
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool gen-wave-timers ${traced}
      ${registers}/${CHIP_STEM}_traced.hpp
    DEPENDS ${generate}/gen_wave_timers.py ${traced})
endfunction()
