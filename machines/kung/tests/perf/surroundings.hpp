// SPDX-License-Identifier: Apache-2.0
//
// The two-axis machine as Verilator's manual shows a SystemC model: the chip is an sc_module made
// by --sc, every pin is a signal, an sc_clock drives it, and all around it are processes that
// wait for the clock or for pins. No look-ahead, no cosim::Loop.
#pragma once

#include <Vkung_xy_sc.h>

#include <array>
#include <fstream>
#include <memory>
#include <systemc>

#include "machines/kung/chip/verilated/adc.hpp"
#include "machines/kung/run/recorder.hpp"
#include "machines/kung/run/session.hpp"

namespace trammel::perf {

template <class T>
using Pin = sc_core::sc_signal<T>;

struct Pins {
  Pin<bool> rst{"rst"};
  Pin<std::uint32_t> leap{"leap"};
  Pin<bool> awvalid{"awvalid"}, awready{"awready"}, wvalid{"wvalid"}, wready{"wready"};
  Pin<bool> bvalid{"bvalid"}, bready{"bready"}, arvalid{"arvalid"}, arready{"arready"};
  Pin<bool> rvalid{"rvalid"}, rready{"rready"};
  Pin<std::uint32_t> awaddr{"awaddr"}, awprot{"awprot"}, wdata{"wdata"}, wstrb{"wstrb"};
  Pin<std::uint32_t> bresp{"bresp"}, araddr{"araddr"}, arprot{"arprot"}, rdata{"rdata"};
  Pin<std::uint32_t> rresp{"rresp"};
  Pin<std::uint32_t> enc_a{"enc_a"}, enc_b{"enc_b"}, enc_z{"enc_z"};
  Pin<bool> trip{"trip"};
  Pin<std::uint32_t> adc_cs_n{"adc_cs_n"}, adc_sclk{"adc_sclk"};
  Pin<std::uint32_t> adc_sdata_a{"adc_sdata_a"}, adc_sdata_b{"adc_sdata_b"};
  Pin<std::uint32_t> gate_hi{"gate_hi"}, gate_lo{"gate_lo"};
  Pin<bool> irq{"irq"}, tick{"tick"}, sample{"sample"}, quiescent{"quiescent"};
  Pin<std::uint32_t> next{"next"}, clock_en{"clock_en"}, awake{"awake"};
  Pin<bool> timed{"timed"}, tripped{"tripped"};
  Pin<std::uint32_t> driver_en{"driver_en"};
};

// What the record needs of a chip, from its pins and its registers.
class PinChip final : public kung::KungChip {
 public:
  PinChip(const Pins& pins, Vkung_xy_sc& model) : pins_(pins), model_(model) {}

  void executed(cosim::Clk edge) { now_ = edge + 1; }
  void answered(std::uint32_t data) { rdata_ = data; }

  cosim::Clk now() const override { return now_; }
  cosim::Clk evaluated() const override { return now_; }
  cosim::Lines drive() const override;
  bool irq() const override { return pins_.irq.read(); }
  std::uint32_t rdata() const override { return rdata_; }
  void read_words(int axis, kung::AxisSample& sample) const override;

  // Nothing asks for these.
  void sense(cosim::Lines) override {}
  void request(const cosim::BusOp&) override {}
  cosim::Stop run(cosim::Clk, const cosim::Plant&) override { return {}; }
  kung::CurrentWords current(int) const override { return {}; }
  std::int32_t rule(int, int) const override { return 0; }
  std::int32_t integral(int) const override { return 0; }
  kung::Fault fault() const override { return {}; }

 private:
  const Pins& pins_;
  Vkung_xy_sc& model_;
  cosim::Clk now_ = 0;
  std::uint32_t rdata_ = 0;
};

// Pins of a chip in reset at the edges -4 to -1; edge 0 is the first without.
class Surroundings final : public sc_core::sc_module, private sw::Bus {
 public:
  sc_core::sc_in<bool> clk{"clk"};

  Surroundings(sc_core::sc_module_name name, const kung::Options& options, Pins& pins,
               Vkung_xy_sc& model, const std::string& pins_file);

  // Half a period before `end` edges have run.
  sc_core::sc_time stop_time(cosim::Clk end) const { return time_of(end) - half(); }
  sc_core::sc_time period() const { return 2 * half(); }
  std::uint64_t event_hash() const { return recorder_->event_hash(); }
  std::size_t samples() { return recorder_->take_samples().size(); }
  cosim::Clk edge() const;  // the last one

 private:
  void execute();  // the processor
  void outputs();  // converters, inverters and the record, when a pin of theirs changes
  void move();     // the encoders, half a period before the edge that sees them
  void log();      // pins that the coming edge sees

  std::uint32_t read(std::uint32_t addr) override { return transfer({addr, 0, false}); }
  void write(std::uint32_t addr, std::uint32_t data) override { transfer({addr, data, true}); }
  std::uint32_t transfer(const cosim::BusOp& op);

  void serve_converters(cosim::Clk edge);
  void put_encoders();
  void await_move();
  sc_core::sc_time half() const;
  sc_core::sc_time time_of(cosim::Clk edge) const;

  kung::Options options_;
  Pins& pins_;
  PinChip chip_;
  std::shared_ptr<const kung::Plan> plan_;
  std::unique_ptr<kung::StallableApp> firmware_;
  std::unique_ptr<kung::TablePlant> plant_;
  std::unique_ptr<kung::Recorder> recorder_;
  sc_core::sc_event done_event_, move_event_;
  std::array<std::array<kung::SerialAdc, 2>, kung::kAxes> adc_{};
  unsigned cs_n_ = 3, sclk_ = 3;
  cosim::Lines drive_ = 0;
  bool irq_ = false, tick_ = false, done_ = false;
  std::ofstream pins_log_;
  std::string last_line_;
};

}  // namespace trammel::perf
