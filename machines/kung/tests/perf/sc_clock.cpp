// SPDX-License-Identifier: Apache-2.0
//
// Row `sc` of `trammel perf`: the reference all ratios refer to. See surroundings.hpp.
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/tests/perf/row.hpp"
#include "machines/kung/tests/perf/surroundings.hpp"

namespace trammel::perf {
namespace {

void bind(Vkung_xy_sc& chip, Pins& pins) {
  chip.rst_i(pins.rst);
  chip.clock_en_i(pins.clock_en);
  chip.leap_i(pins.leap);
  chip.s_axil_awvalid_i(pins.awvalid);
  chip.s_axil_awready_o(pins.awready);
  chip.s_axil_awaddr_i(pins.awaddr);
  chip.s_axil_awprot_i(pins.awprot);
  chip.s_axil_wvalid_i(pins.wvalid);
  chip.s_axil_wready_o(pins.wready);
  chip.s_axil_wdata_i(pins.wdata);
  chip.s_axil_wstrb_i(pins.wstrb);
  chip.s_axil_bvalid_o(pins.bvalid);
  chip.s_axil_bready_i(pins.bready);
  chip.s_axil_bresp_o(pins.bresp);
  chip.s_axil_arvalid_i(pins.arvalid);
  chip.s_axil_arready_o(pins.arready);
  chip.s_axil_araddr_i(pins.araddr);
  chip.s_axil_arprot_i(pins.arprot);
  chip.s_axil_rvalid_o(pins.rvalid);
  chip.s_axil_rready_i(pins.rready);
  chip.s_axil_rdata_o(pins.rdata);
  chip.s_axil_rresp_o(pins.rresp);
  chip.enc_a_i(pins.enc_a);
  chip.enc_b_i(pins.enc_b);
  chip.enc_z_i(pins.enc_z);
  chip.trip_i(pins.trip);
  chip.adc_cs_n_o(pins.adc_cs_n);
  chip.adc_sclk_o(pins.adc_sclk);
  chip.adc_sdata_a_i(pins.adc_sdata_a);
  chip.adc_sdata_b_i(pins.adc_sdata_b);
  chip.gate_hi_o(pins.gate_hi);
  chip.gate_lo_o(pins.gate_lo);
  chip.irq_o(pins.irq);
  chip.tick_o(pins.tick);
  chip.sample_o(pins.sample);
  chip.next_o(pins.next);
  chip.quiescent_o(pins.quiescent);
  chip.awake_o(pins.awake);
  chip.timed_o(pins.timed);
  chip.driver_en_o(pins.driver_en);
  chip.tripped_o(pins.tripped);
}

Outcome run_sc(const Arguments& arguments) {
  Verilated::assertOn(false);
  Verilated::randReset(2);
  Verilated::randSeed(1);
  Pins pins;
  const auto chip = std::make_unique<Vkung_xy_sc>("chip");
  bind(*chip, pins);
  Surroundings surroundings("board", arguments.options, pins, *chip, arguments.pins);
  sc_core::sc_clock clk("clk", surroundings.period(), 0.5, surroundings.period(), true);
  surroundings.clk(clk);
  chip->clk_i(clk);
  sc_core::sc_start(
      surroundings.stop_time(arguments.options.run.clocks(arguments.options.run.max_s)));
  const cosim::Clk clocks = surroundings.edge() + 1;
  chip->final();
  return {clocks, clocks, surroundings.event_hash(), surroundings.samples()};
}

}  // namespace
}  // namespace trammel::perf

int main(int argc, char** argv) {
  return trammel::perf::report(argc, argv, trammel::perf::run_sc);
}
