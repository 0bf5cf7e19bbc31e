// SPDX-License-Identifier: Apache-2.0
//
// First instructions after reset, behind them the header of sw_nios/hal/soc_map.hpp: stack, zeroed
// .bss, main().
  .section .start, "ax"
  .global _start
_start:
  j begin
  .word 0x4C4D5254
  .word core_setup
  .word core_report
  .word bss_end
  .word stack_bottom
begin:
  la sp, stack_top
  la t0, bss_begin
  la t1, bss_end
1:
  bgeu t0, t1, 2f
  sw zero, 0(t0)
  addi t0, t0, 4
  j 1b
2:
  call main
3:
  j 3b
