// SPDX-License-Identifier: Apache-2.0
#include "machines/kung/tests/perf/surroundings.hpp"

#include <fmt/format.h>

#include <Vkung_xy_sc___024root.h>

#include "machines/kung/chip/verilated/probe.hpp"
#include "machines/kung/plan/register_values.hpp"
#include "machines/kung/run/make_plan.hpp"
#include "rtl/chips/generated/kung_xy_regs.hpp"

namespace trammel::perf {

using namespace sc_core;

namespace {
constexpr cosim::Clk kResetEdges = 4;
constexpr cosim::Clk kOrigin = kResetEdges + 1;  // edge n stands at n + kOrigin periods
}  // namespace

cosim::Lines PinChip::drive() const {
  return kung::gates(pins_.gate_hi.read(), pins_.gate_lo.read());
}

void PinChip::read_words(int axis, kung::AxisSample& sample) const {
  kung::probe_words(*model_.rootp, axis, sample);
}

Surroundings::Surroundings(sc_module_name name, const kung::Options& options, Pins& pins,
                           Vkung_xy_sc& model, const std::string& pins_file)
    : sc_module(name), options_(options), pins_(pins), chip_(pins, model) {
  plan_ = kung::make_plan(options_);
  const sw::KungSetup& setup = plan_->setup;
  firmware_ = std::make_unique<kung::StallableApp>(setup, chip_);
  const sw::Point start = sw::Trajectory(setup).start();
  options_.plant.axis[0].start_m = start.x * options_.plant.axis[0].encoder_count_m;
  options_.plant.axis[1].start_m = start.y * options_.plant.axis[1].encoder_count_m;
  plant_ = std::make_unique<kung::TablePlant>(options_.plant);
  recorder_ = std::make_unique<kung::Recorder>(
      chip_, plant_->table(), options_.controller == kung::Controller::kPrecision,
      [](const kung::Sample&) { return false; });
  SC_HAS_PROCESS(Surroundings);
  SC_THREAD(execute);
  sensitive << clk.pos();
  SC_METHOD(outputs);
  sensitive << pins_.gate_hi << pins_.gate_lo << pins_.adc_cs_n << pins_.adc_sclk << pins_.irq
            << pins_.tick << pins_.sample << done_event_;
  dont_initialize();
  SC_METHOD(move);
  sensitive << move_event_;
  dont_initialize();
  if (!pins_file.empty()) {
    pins_log_.open(pins_file);
    SC_METHOD(log);
    sensitive << clk.pos();
    dont_initialize();
  }
}

sc_time Surroundings::half() const {
  return sc_time::from_value(static_cast<sc_dt::uint64>(options_.run.clock_ps / 2));
}

sc_time Surroundings::time_of(cosim::Clk edge) const {
  return sc_time::from_value(
      static_cast<sc_dt::uint64>((edge + kOrigin) * options_.run.clock_ps));
}

cosim::Clk Surroundings::edge() const {
  return static_cast<cosim::Clk>(sc_time_stamp().value()) / options_.run.clock_ps - kOrigin;
}

void Surroundings::execute() {
  pins_.rst = true;
  pins_.bready = true;
  pins_.rready = true;
  pins_.wstrb = 0xf;
  pins_.clock_en = 0xfff;  // no clock is gated
  wait(static_cast<int>(kResetEdges));
  pins_.rst = false;
  move_event_.notify(SC_ZERO_TIME);
  wait();
  firmware_->start(*this);
  for (;;) {
    while (!pins_.irq.read()) wait(pins_.irq.posedge_event());
    wait(options_.processor.interrupt_latency_clk);
    firmware_->isr(*this);
  }
}

// What is written after one edge is seen by the next: the transfer is valid `access_clk` edges
// after the one at which the processor stands, and ends at the one that takes the response.
std::uint32_t Surroundings::transfer(const cosim::BusOp& op) {
  const bool computes =
      op.write && options_.point_clk > 0 && op.addr == kung_xy_regs::kX + kung_xy_regs::kPosCmd;
  wait(options_.processor.access_clk - 1 + (computes ? options_.point_clk : 0));
  if (op.write) {
    pins_.awaddr = op.addr;
    pins_.wdata = op.data;
    pins_.awvalid = true;
    pins_.wvalid = true;
  } else {
    pins_.araddr = op.addr;
    pins_.arvalid = true;
  }
  bool done = false;
  while (!done) {
    wait();
    if (pins_.awvalid && pins_.awready) pins_.awvalid = false;
    if (pins_.wvalid && pins_.wready) pins_.wvalid = false;
    if (pins_.arvalid && pins_.arready) pins_.arvalid = false;
    if (pins_.rvalid) chip_.answered(pins_.rdata.read());
    done = pins_.bvalid || pins_.rvalid;
  }
  done_ = true;
  done_event_.notify(SC_ZERO_TIME);
  wait(SC_ZERO_TIME);  // the interrupt line that this edge leaves
  return chip_.rdata();
}

void Surroundings::outputs() {
  const cosim::Clk now = edge();
  if (now < 0) {  // in reset
    tick_ = pins_.tick;
    return;
  }
  chip_.executed(now);
  serve_converters(now);
  unsigned why = done_ ? cosim::kBusDone : 0u;
  const cosim::Lines drive = chip_.drive();
  if (drive != drive_) why |= cosim::kDrive;
  if (pins_.irq && !irq_) why |= cosim::kIrq;
  if (tick_ && !pins_.tick) why |= cosim::kTick;
  if (pins_.sample.posedge()) why |= cosim::kSample;
  if ((why & cosim::kDrive) != 0) {
    plant_->commit(now, drive);
    await_move();
  }
  drive_ = drive;
  irq_ = pins_.irq;
  tick_ = pins_.tick;
  done_ = false;
  if (why != 0) recorder_->on({now, why}, chip_, *plant_);
}

void Surroundings::serve_converters(cosim::Clk now) {
  const unsigned cs = pins_.adc_cs_n.read();
  const unsigned sclk = pins_.adc_sclk.read();
  if (cs == cs_n_ && sclk == sclk_) return;
  for (std::size_t axis = 0; axis < adc_.size(); ++axis) {
    const unsigned bit = 1u << axis;
    if ((cs_n_ & ~cs & bit) != 0) {
      for (std::size_t phase = 0; phase < 2; ++phase) {
        const int channel = kung::adc_channel(static_cast<int>(axis), static_cast<int>(phase));
        adc_[axis][phase].hold(plant_->sample(channel, now));
      }
    } else if ((sclk_ & ~sclk & bit) != 0) {
      for (auto& adc : adc_[axis]) adc.clock_fell();
    }
  }
  cs_n_ = cs;
  sclk_ = sclk;
  const auto line = [this](std::size_t phase) {
    return static_cast<std::uint32_t>(adc_[0][phase].data() | (adc_[1][phase].data() << 1));
  };
  pins_.adc_sdata_a = line(0);
  pins_.adc_sdata_b = line(1);
}

void Surroundings::put_encoders() {
  const cosim::Lines lines = plant_->sense();
  pins_.enc_a = kung::encoder_a.value(lines);
  pins_.enc_b = kung::encoder_b.value(lines);
  pins_.enc_z = kung::encoder_z.value(lines);
  pins_.trip = level(lines, kung::kTripPin);
}

void Surroundings::await_move() {
  move_event_.cancel();
  const cosim::Clk next = plant_->next();
  if (next != cosim::kNever) move_event_.notify(time_of(next) - half() - sc_time_stamp());
}

void Surroundings::move() {
  if (plant_->next() == edge() + 1) plant_->commit(plant_->next(), drive_);
  put_encoders();
  await_move();
}

// One line for every clock that sees other inputs than the one before: edge, inputs in hex digits.
void Surroundings::log() {
  const std::string line = fmt::format(
      "{:x}{:x}{:x}{:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x} {:x}", pins_.rst.read(),
      pins_.awvalid.read(), pins_.wvalid.read(), pins_.arvalid.read(), pins_.awaddr.read(),
      pins_.araddr.read(), pins_.wdata.read(), pins_.enc_a.read(), pins_.enc_b.read(),
      pins_.enc_z.read(), pins_.trip.read(), pins_.adc_sdata_a.read(), pins_.adc_sdata_b.read());
  if (line == last_line_) return;
  pins_log_ << edge() << ' ' << line << '\n';
  last_line_ = line;
}

}  // namespace trammel::perf
