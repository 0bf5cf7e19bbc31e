trammel_chip(kung_xy INTERFACE KungChip)

# The processor of kung_soc, for `run.cpu = "rtl"`, and the image of its firmware: where the core's
# RTL and the cross compiler are here. Without them such runs are refused.
find_program(TRAMMEL_CROSS riscv64-unknown-elf-g++)
if(TRAMMEL_PICORV32 AND TRAMMEL_CROSS AND NOT TRAMMEL_FUZZ)
  trammel_verilated_library(model_soc_host)
  target_link_libraries(model_soc_host INTERFACE trammel_verilator)
  list(APPEND chip_models model_soc_host)
  trammel_verilate(model_soc_host soc_host_fast "-O3;-fno-tree-pre;-march=${TRAMMEL_MARCH}"
    TOP_MODULE soc_host PREFIX Vsoc_host_fast
    SOURCES ${CMAKE_CURRENT_LIST_DIR}/chip/verilated/soc/public.vlt ${TRAMMEL_PICORV32}
      ${PROJECT_SOURCE_DIR}/rtl/chips/soc_host.sv
    VERILATOR_ARGS -Wno-fatal -O3 --x-assign fast --x-initial unique ${TRAMMEL_RTL_SEARCH})
  set(image ${registers}/kung_image.inc)
  if(NOT TRAMMEL_BASE)
    set(root ${PROJECT_BINARY_DIR}/verilated/soc_host_fast/Vsoc_host_fast___024root.h)
    trammel_gen_model_state(${registers}/soc_host_state.hpp ${root})
    file(GLOB_RECURSE firmware CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/sw_nios/*)
    add_custom_command(OUTPUT ${image}
      COMMAND ${PROJECT_SOURCE_DIR}/scripts/tool firmware --words kung ${image}
      DEPENDS ${PROJECT_SOURCE_DIR}/scripts/trammel_tools/check/firmware.py ${firmware}
        ${PROJECT_SOURCE_DIR}/rtl/chips/generated/kung_xy_regs.hpp
      COMMENT "Compiling the firmware of kung_soc")
  endif()
  list(APPEND chip_headers ${registers}/soc_host_state.hpp ${image})
  set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/chip/soc.cpp PROPERTIES
    COMPILE_DEFINITIONS TRAMMEL_CORE INCLUDE_DIRECTORIES ${registers} OBJECT_DEPENDS ${image})
  set_source_files_properties(${CMAKE_CURRENT_LIST_DIR}/chip/verilated/soc_core.cpp PROPERTIES
    COMPILE_DEFINITIONS TRAMMEL_CORE)
endif()
