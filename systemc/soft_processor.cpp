// SPDX-License-Identifier: Apache-2.0
#include "systemc/soft_processor.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace trammel::systemc {

using namespace sc_core;

SoftProcessor::SoftProcessor(sc_module_name name, ChipModule& chip, sw::Firmware& firmware,
                             const cosim::ProcessorTiming& timing, std::int64_t period_ps)
    : sc_module(name),
      bus("bus"),
      chip_(chip),
      firmware_(firmware),
      timing_(timing),
      period_ps_(period_ps) {
  bus.bind(chip.bus);
  SC_HAS_PROCESS(SoftProcessor);
  SC_THREAD(execute);
}

cosim::Clk SoftProcessor::now() const {
  return static_cast<cosim::Clk>(sc_time_stamp().value()) / period_ps_;
}

sc_time SoftProcessor::clocks(cosim::Clk count) const {
  return sc_time::from_value(static_cast<sc_dt::uint64>(count * period_ps_));
}

void SoftProcessor::execute() {
  firmware_.start(*this);
  for (;;) {
    while (!chip_.irq()) wait(chip_.irq_event);
    wait(clocks(timing_.fault.work(now(), timing_.latency)));
    firmware_.isr(*this);
  }
}

std::uint32_t SoftProcessor::read(std::uint32_t addr) {
  std::uint32_t data = 0;
  transfer(tlm::TLM_READ_COMMAND, addr, data);
  return data;
}

void SoftProcessor::write(std::uint32_t addr, std::uint32_t data) {
  transfer(tlm::TLM_WRITE_COMMAND, addr, data);
}

void SoftProcessor::transfer(tlm::tlm_command command, std::uint32_t addr, std::uint32_t& data) {
  payload_.set_command(command);
  payload_.set_address(addr);
  payload_.set_data_ptr(reinterpret_cast<unsigned char*>(&data));
  payload_.set_data_length(sizeof data);
  payload_.set_streaming_width(sizeof data);
  payload_.set_byte_enable_ptr(nullptr);
  payload_.set_response_status(tlm::TLM_INCOMPLETE_RESPONSE);
  const bool writes = command == tlm::TLM_WRITE_COMMAND;
  const cosim::Clk taken = timing_.before(now(), {addr, data, writes});
  if (writes) data = timing_.fault.written(now() + taken, data);
  sc_time delay = clocks(taken);
  bus->b_transport(payload_, delay);
  if (payload_.is_response_error()) {
    throw std::logic_error(fmt::format("bus: {} at address {:#x} was refused: {}",
                                       command == tlm::TLM_READ_COMMAND ? "read" : "write", addr,
                                       payload_.get_response_string()));
  }
}

}  // namespace trammel::systemc
