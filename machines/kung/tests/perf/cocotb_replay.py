# SPDX-License-Identifier: Apache-2.0
"""Replays recorded pins into kung_xy under cocotb and writes the lines that replay.v prints.

PERF_PINS names the pins, PERF_EVENTS the file to write, PERF_END the edge at which it ends.
"""

import os

import cocotb
from cocotb.clock import Clock
from cocotb.triggers import FallingEdge

FIELDS = ("s_axil_awaddr_i", "s_axil_araddr_i", "s_axil_wdata_i", "enc_a_i", "enc_b_i", "enc_z_i",
          "trip_i", "adc_sdata_a_i", "adc_sdata_b_i")
FLAGS = ("rst_i", "s_axil_awvalid_i", "s_axil_wvalid_i", "s_axil_arvalid_i")
QUIET = ("leap_i", "s_axil_awprot_i", "s_axil_arprot_i")


def put(dut, line):
    flags, *words = line
    for name, digit in zip(FLAGS, flags):
        getattr(dut, name).value = int(digit)
    for name, word in zip(FIELDS, words):
        getattr(dut, name).value = int(word, 16)


def words_of(dut):
    for axis in (0, 1):
        afc = dut.gen_axis[axis].u_axis.u_afc
        yield afc.x_m_q.value.to_unsigned()
        yield afc.i_q_ref_q.value.to_unsigned()


@cocotb.test()
async def replay(dut):
    with open(os.environ["PERF_PINS"], encoding="ascii") as file:
        changes = {int(words[0]): words[1:] for words in map(str.split, file)}
    for name in QUIET:
        getattr(dut, name).value = 0
    dut.clock_en_i.value = 0xfff  # no clock is gated
    dut.s_axil_wstrb_i.value = 15
    dut.s_axil_bready_i.value = 1
    dut.s_axil_rready_i.value = 1
    cocotb.start_soon(Clock(dut.clk_i, 20, "ns").start(start_high=False))
    data, before = 0, (0, 0, 0)
    ended = ticked = False
    with open(os.environ["PERF_EVENTS"], "w", encoding="ascii") as out:
        for edge in range(-4, int(os.environ["PERF_END"]) + 1):
            if edge != -4:
                await FallingEdge(dut.clk_i)
                hi, lo, irq, tick, sample = (
                    int(p.value) if p.value.is_resolvable else 0 for p in
                    (dut.gate_hi_o, dut.gate_lo_o, dut.irq_o, dut.tick_o, dut.sample_o))
                if edge > 0 and (ended or ticked or sample or irq > before[2] or
                                 (hi, lo) != before[:2]):
                    out.write(f"{edge - 1} {hi:x} {lo:x} {irq}{ticked:d}{sample}{ended:d} "
                              f"{data:x} {' '.join(f'{w:x}' for w in words_of(dut))}\n")
                before = (hi, lo, irq)
                ticked = tick
                reads = int(dut.s_axil_rvalid_o.value)
                ended = reads or int(dut.s_axil_bvalid_o.value)
                if reads:
                    data = int(dut.s_axil_rdata_o.value)
            if edge in changes:
                put(dut, changes[edge])
