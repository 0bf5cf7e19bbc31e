// SPDX-License-Identifier: Apache-2.0
//
// Rows of `trammel perf` on the --cc model: `clocked` activates it in SystemC once per clock,
// `speed` replaces its plant, the others are the program's own platform with other keys.
#include <systemc>

#include "lab/machine.hpp"
#include "machines/kung/run/session.hpp"
#include "machines/kung/tests/perf/row.hpp"
#include "machines/kung/tests/perf/speed.hpp"

namespace trammel::perf {
namespace {

using namespace sc_core;

sc_time clocks(cosim::Clk count, std::int64_t period_ps) {
  return sc_time::from_value(static_cast<sc_dt::uint64>(count * period_ps));
}

// One activation per rising edge, and one edge per activation. Edge n is at n periods.
class ClockedChip final : public sc_module {
 public:
  sc_in<bool> clk{"clk"};
  sc_event irq_event, done_event;

  ClockedChip(sc_module_name name, cosim::Loop& loop) : sc_module(name), loop_(loop) {
    SC_HAS_PROCESS(ClockedChip);
    SC_METHOD(edge);
    sensitive << clk.pos();
    dont_initialize();
  }

  cosim::Chip& chip() { return loop_.chip(); }

 private:
  void edge() {
    const cosim::Stop stop = loop_.advance(loop_.chip().now() + 1);
    if ((stop.why & cosim::kBusDone) != 0) done_event.notify(SC_ZERO_TIME);
    if ((stop.why & cosim::kIrq) != 0) irq_event.notify(SC_ZERO_TIME);
  }

  cosim::Loop& loop_;
};

// A request made at the time of an edge comes before that edge: the clock signal rises a delta
// cycle after time has moved on.
class Processor final : public sc_module, private sw::Bus {
 public:
  Processor(sc_module_name name, ClockedChip& chip, kung::Session& session)
      : sc_module(name), chip_(chip), session_(session) {
    SC_HAS_PROCESS(Processor);
    SC_THREAD(execute);
  }

 private:
  void execute() {
    session_.firmware().start(*this);
    for (;;) {
      while (!chip_.chip().irq()) wait(chip_.irq_event);
      wait(clocks(session_.timing().latency, session_.period_ps()));
      session_.firmware().isr(*this);
    }
  }

  std::uint32_t read(std::uint32_t addr) override { return transfer({addr, 0, false}); }
  void write(std::uint32_t addr, std::uint32_t data) override { transfer({addr, data, true}); }

  std::uint32_t transfer(const cosim::BusOp& op) {
    wait(clocks(session_.timing().before(chip_.chip().now(), op), session_.period_ps()));
    chip_.chip().request(op);
    wait(chip_.done_event);
    return chip_.chip().rdata();
  }

  ClockedChip& chip_;
  kung::Session& session_;
};

Outcome outcome(const cosim::RunResult& result) {
  return {result.clocks, result.evaluated, result.event_hash, result.sample_count()};
}

Outcome run_clocked(kung::Options options) {
  options.run.leap = false;
  kung::Session session(options, {});
  sc_clock clk("clk", clocks(1, session.period_ps()));
  ClockedChip chip("chip", session.loop());
  chip.clk(clk);
  Processor processor("processor", chip, session);
  // Half a period before the edge that must not come.
  sc_start(clocks(session.end(), session.period_ps()) - clocks(1, session.period_ps() / 2));
  return outcome(*session.result());
}

Outcome run_row(const Arguments& arguments) {
  if (arguments.row == "clocked") return run_clocked(arguments.options);
  if (arguments.row == "speed") return run_speed(arguments);
  return outcome(simulate(arguments.options));
}

}  // namespace
}  // namespace trammel::perf

int main(int argc, char** argv) {
  return trammel::perf::report(argc, argv, trammel::perf::run_row);
}
