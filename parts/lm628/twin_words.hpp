// SPDX-License-Identifier: Apache-2.0
//
// The words of the twin of an LM628 for the record.
#pragma once

#include <cstdint>

#include "parts/lm628/chip.hpp"
#include "models/exact/chips/lm628.hpp"

namespace trammel::lm628 {

inline Words words_of(const exact::Lm628& part) {
  const exact::Lm628Engine& engine = part.engine();
  Words w;
  w.position = engine.desired().position;
  w.speed = static_cast<std::int32_t>(engine.desired().speed);
  w.actual = static_cast<std::int32_t>(engine.actual());
  derive_error(w, engine.filter().kp);
  w.integral = static_cast<std::int32_t>(engine.pid().integral(engine.filter()));
  w.derivative = static_cast<std::int32_t>(engine.pid().derivative());
  w.output = static_cast<std::int32_t>(engine.output());
  w.status = part.status();
  return w;
}

}  // namespace trammel::lm628
