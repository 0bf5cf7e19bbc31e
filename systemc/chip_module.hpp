// SPDX-License-Identifier: Apache-2.0
//
// A chip and its plant as one SystemC module: the loop runs ahead exactly to the next kernel
// activity, so gates and encoder edges never cross the kernel. Bus transfers arrive by TLM-2.0.
#pragma once

#include <tlm.h>
#include <tlm_utils/simple_target_socket.h>

#include <exception>
#include <functional>
#include <optional>
#include <systemc>

#include "cosim/cosim.hpp"

namespace trammel::systemc {

class ChipModule final : public sc_core::sc_module {
 public:
  tlm_utils::simple_target_socket<ChipModule> bus;
  sc_core::sc_event irq_event;

  // Stops the simulation at edge `end`, or as soon as `finished()` holds.
  ChipModule(sc_core::sc_module_name name, cosim::Loop& loop, std::int64_t period_ps,
             cosim::Clk end, std::function<bool()> finished);

  bool irq() const { return loop_.chip().irq(); }

  // After the simulation: throws what the loop has thrown. SystemC would make a report of it.
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  void execute();
  void simulate();
  cosim::Stop advance(cosim::Clk until);
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay);
  cosim::Clk limit() const;
  cosim::Clk edge_at(const sc_core::sc_time& time) const;
  sc_core::sc_time time_of(cosim::Clk edge) const;

  cosim::Loop& loop_;
  std::int64_t period_ps_;
  cosim::Clk end_;
  std::function<bool()> finished_;
  sc_core::sc_event done_event_;
  std::optional<cosim::BusOp> asked_;  // a transfer to come,
  cosim::Clk asked_from_ = 0;          // from this edge on
  std::exception_ptr error_;
};

}  // namespace trammel::systemc
