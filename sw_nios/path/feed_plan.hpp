// SPDX-License-Identifier: Apache-2.0
//
// The look-ahead of the feed profile (docs/precision.md, "Feed profile"): where a table that keeps
// the acceleration of each axis must stop, how fast it may go through every corner, and when. It
// takes the segments of a path and gives the phases of its chains. step() does a little of it and
// is called until it says so, before the table moves. Nothing is allocated.
#pragma once

#include <cstdint>

#include "sw_nios/path/feed_corner.hpp"
#include "sw_nios/path/feed_path.hpp"
#include "sw_nios/path/feed_real.hpp"
#include "sw_nios/path/feed_segment.hpp"

namespace trammel::sw {

// A stretch with the same limits, while its chain is planned.
struct FeedPiece {
  std::uint64_t length = 0;  // Q32
  std::uint64_t speed = 0;   // Q40, at most
  std::uint64_t accel = 0;   // Q40, at most
  std::uint64_t begin = 0;   // Q40: speed at its beginning
  std::uint64_t corner_speed = 0, corner_accel = 0;  // Q40: of the corner at its beginning
  std::uint32_t next = 0, before = 0;
  bool free = true;  // of the zones of corners
};

class FeedPlanner {
 public:
  enum class State : std::uint8_t { kBusy, kDone, kNoRoom, kTooLong };

  struct Work {
    FeedSegment* segments = nullptr;  // `stop` is set where a chain ends
    std::uint32_t n_segments = 0;
    FeedPhase* phases = nullptr;      // the result
    std::uint32_t phase_room = 0;     // at most 10 a segment are needed
    FeedPiece* pieces = nullptr;      // of use until the end of the planning
    std::uint32_t piece_room = 0;     // at most 3 a segment of the longest chain, and 1
  };

  FeedPlanner(const Work& work, const FeedLimits& limits) : w_(work), limits_(limits) {
    if (w_.n_segments == 0) state_ = State::kDone;
  }

  State state() const { return state_; }
  std::uint32_t phases() const { return n_phases_; }
  std::uint32_t pieces() const { return most_pieces_; }
  std::uint32_t ticks() const { return ticks_; }  // points of a lap

  State step();

 private:
  enum class Stage : std::uint8_t { kSegment, kCorner, kBackward, kForward, kPhases };
  static constexpr std::uint32_t kNone = 0xFFFFFFFFu;

  // Around a corner, with the path of the chain where it begins and ends.
  struct Zone {
    std::uint64_t speed = 0, accel = 0, from = 0, to = 0;
    std::uint32_t next = kNone;  // piece that begins where it ends
  };

  std::uint32_t new_piece();

  // The chain's segments become pieces, up to its last one: piece k begins with its k-th segment.
  void add_segment();

  // Around a corner the lower limits of speed and acceleration hold for as many points as the mean
  // sees of it.
  void apply_corner();

  // From piece `at` on, backward or forward, over `reach` of path; the piece behind that.
  std::uint32_t limit(std::uint32_t at, bool back, std::uint64_t reach, std::uint64_t speed,
                      std::uint64_t accel);

  // Cuts a piece after `length`; the part asked for. The piece of a corner stays behind it.
  std::uint32_t split(std::uint32_t at, std::uint64_t length, bool last);

  // The highest speed at one end of a piece that has `from` at the other.
  static std::uint64_t reached(std::uint64_t from, const FeedPiece& p);
  void look_back();
  void look_forward();

  // Up to the fastest of the piece, along, and down to where the next one begins; gently between
  // two corners.
  void add_phases();

  // None where the motion before goes on.
  void add_phase(Real duration, std::uint64_t path, std::uint64_t speed, std::int64_t accel);
  void end_chain();

  static constexpr std::uint64_t kMostTicks = 1u << 30;

  Work w_;
  FeedLimits limits_;
  FeedBounds bounds_, corner_bounds_;  // of the next segment, and of the corner before it
  State state_ = State::kBusy;
  Stage stage_ = Stage::kSegment;
  std::uint32_t segment_ = 0;   // the next one
  std::uint32_t corner_ = 1, corners_ = 0;
  Zone zone_;                   // the last one
  std::uint32_t n_pieces_ = 0, most_pieces_ = 0, piece_ = 0;
  std::uint32_t n_phases_ = 0, chain_ = 0;  // where the phases of this chain begin
  std::uint64_t speed_ = 0;                 // Q40, at the end of the piece
  std::uint64_t time_ = 0, path_ = 0;       // of the chain so far, Q32
  std::uint32_t ticks_ = 0;
};

}  // namespace trammel::sw
