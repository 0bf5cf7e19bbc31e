// SPDX-License-Identifier: Apache-2.0
//
// After a fault that was injected and noticed the way to rest is recorded, too.
#pragma once

namespace trammel::lm628 {

class Coast {
 public:
  // After each sample since the fault was noticed; `rests` by the speed of the plant.
  bool over(bool rests) {
    ++samples_;
    return (rests && samples_ > kLeast) || samples_ > kMost;
  }

 private:
  static constexpr int kLeast = 2, kMost = 2000;  // [sample]
  int samples_ = 0;
};

}  // namespace trammel::lm628
