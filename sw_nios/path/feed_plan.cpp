// SPDX-License-Identifier: Apache-2.0
#include "sw_nios/path/feed_plan.hpp"

namespace trammel::sw {
namespace {

Real length_of(std::uint64_t q32) { return Real(q32, 32); }
Real rate_of(std::uint64_t q40) { return Real(q40, kFeedBits); }

}  // namespace

FeedPlanner::State FeedPlanner::step() {
  switch (stage_) {
    case Stage::kSegment: add_segment(); break;
    case Stage::kCorner: apply_corner(); break;
    case Stage::kBackward: look_back(); break;
    case Stage::kForward: look_forward(); break;
    case Stage::kPhases: add_phases(); break;
  }
  return state_;
}

std::uint32_t FeedPlanner::new_piece() {
  if (n_pieces_ == w_.piece_room) {
    state_ = State::kNoRoom;
    return 0;
  }
  if (n_pieces_ + 1 > most_pieces_) most_pieces_ = n_pieces_ + 1;
  return n_pieces_++;
}

void FeedPlanner::add_segment() {
  FeedSegment& g = w_.segments[segment_];
  const std::uint32_t at = new_piece();
  if (state_ != State::kBusy) return;
  if (at == 0) bounds_ = feed_bounds(g, limits_);
  FeedPiece& p = w_.pieces[at];
  p.length = g.length;
  p.speed = bounds_.speed.fixed(kFeedBits);
  p.accel = bounds_.accel.fixed(kFeedBits);
  p.before = at == 0 ? kNone : at - 1;
  p.free = true;
  p.next = kNone;
  if (at != 0) {
    w_.pieces[at - 1].next = at;
    p.corner_speed = corner_bounds_.speed.fixed(kFeedBits);
    p.corner_accel = corner_bounds_.accel.fixed(kFeedBits);
  }
  ++segment_;
  if (segment_ == w_.n_segments) g.stop = true;
  if (!g.stop) {
    const FeedSegment& next = w_.segments[segment_];
    const FeedBounds own = bounds_;
    bounds_ = feed_bounds(next, limits_);
    const FeedCorner corner = feed_corner(g, own, next, bounds_, limits_);
    corner_bounds_ = corner.bounds;
    g.stop = corner.stop;
  }
  if (!g.stop) return;
  corner_ = 1;
  corners_ = n_pieces_;
  path_ = w_.pieces[0].length;
  zone_ = {};
  stage_ = Stage::kCorner;
}

void FeedPlanner::apply_corner() {
  if (corner_ >= corners_) {
    stage_ = Stage::kBackward;
    piece_ = 0;
    while (w_.pieces[piece_].next != kNone) piece_ = w_.pieces[piece_].next;
    speed_ = 0;
    return;
  }
  const std::uint64_t speed = w_.pieces[corner_].corner_speed;
  const std::uint64_t accel = w_.pieces[corner_].corner_accel;
  const std::uint64_t reach = mul_right(speed, limits_.mean + 1, kFeedBits - 32 + 1);
  Zone z{speed, accel, path_ > reach ? path_ - reach : 0, path_ + reach, kNone};
  // What the zone before has limited as much, but for rounding, is done.
  const auto below = [](std::uint64_t a, std::uint64_t b) { return a <= b + (b >> 34); };
  const bool as_much =
      zone_.to >= path_ && below(zone_.speed, speed) && below(zone_.accel, accel);
  if (!as_much || zone_.from > z.from) limit(w_.pieces[corner_].before, true, reach, speed, accel);
  if (as_much && zone_.to <= z.to) {
    z.next = zone_.next == kNone ? kNone : limit(zone_.next, false, z.to - zone_.to, speed, accel);
    if (z.to == zone_.to) z.next = zone_.next;
  } else {
    z.next = limit(corner_, false, reach, speed, accel);
  }
  if (state_ != State::kBusy) return;
  zone_ = z;
  path_ += w_.segments[segment_ - corners_ + corner_].length;
  ++corner_;
}

std::uint32_t FeedPlanner::limit(std::uint32_t at, bool back, std::uint64_t reach,
                                 std::uint64_t speed, std::uint64_t accel) {
  while (at != kNone && reach != 0) {
    FeedPiece& p = w_.pieces[at];
    if (p.length <= reach) {
      reach -= p.length;
    } else {
      at = split(at, back ? p.length - reach : reach, back);
      if (state_ != State::kBusy) return kNone;
      reach = 0;
    }
    FeedPiece& inside = w_.pieces[at];
    inside.free = false;
    if (inside.speed > speed) inside.speed = speed;
    if (inside.accel > accel) inside.accel = accel;
    at = back ? inside.before : inside.next;
  }
  return at;
}

std::uint32_t FeedPlanner::split(std::uint32_t at, std::uint64_t length, bool last) {
  const std::uint32_t fresh = new_piece();
  if (state_ != State::kBusy) return at;
  FeedPiece &p = w_.pieces[at], &q = w_.pieces[fresh];
  q = p;
  q.length = p.length - length;
  q.before = at;
  p.length = length;
  p.next = fresh;
  if (q.next != kNone) w_.pieces[q.next].before = fresh;
  return last ? fresh : at;
}

std::uint64_t FeedPlanner::reached(std::uint64_t from, const FeedPiece& p) {
  const Real v = rate_of(from);
  return sqrt(v * v + Real(2) * rate_of(p.accel) * length_of(p.length)).fixed(kFeedBits);
}

void FeedPlanner::look_back() {
  FeedPiece& p = w_.pieces[piece_];
  const bool first = p.before == kNone;
  std::uint64_t v = first ? 0 : p.speed;
  if (!first && w_.pieces[p.before].speed < v) v = w_.pieces[p.before].speed;
  if (v > speed_) {
    const std::uint64_t most = reached(speed_, p);
    if (most < v) v = most;
  }
  p.begin = speed_ = v;
  if (!first) {
    piece_ = p.before;
    return;
  }
  stage_ = Stage::kForward;
}

void FeedPlanner::look_forward() {
  const FeedPiece& p = w_.pieces[piece_];
  if (p.next == kNone) {
    stage_ = Stage::kPhases;
    piece_ = 0;
    time_ = path_ = 0;
    return;
  }
  FeedPiece& q = w_.pieces[p.next];
  if (q.begin > p.begin) {
    const std::uint64_t most = reached(p.begin, p);
    if (most < q.begin) q.begin = most;
  }
  piece_ = p.next;
}

void FeedPlanner::add_phases() {
  const FeedPiece& p = w_.pieces[piece_];
  const std::uint64_t out = p.next == kNone ? 0 : w_.pieces[p.next].begin;
  const Real vi = rate_of(p.begin), vo = rate_of(out), length = length_of(p.length);
  std::uint64_t most = p.accel;
  if (p.free && p.begin != 0 && out != 0) {
    const std::uint64_t swing = feed_swing(length, vi, vo, limits_).fixed(kFeedBits);
    if (swing < most) most = swing;
  }
  const Real a = rate_of(most), squares = (vi * vi + vo * vo) / Real(2);
  std::uint64_t peak = sqrt(squares + a * length).fixed(kFeedBits);
  if (peak > p.speed) peak = p.speed;
  if (peak < p.begin) peak = p.begin;
  if (peak < out) peak = out;
  const Real vp = rate_of(peak), up = (vp * vp - vi * vi) / (Real(2) * a),
             down = (vp * vp - vo * vo) / (Real(2) * a), flat = length - up - down;
  const std::uint64_t end = path_ + p.length;
  const auto accel = static_cast<std::int64_t>(most);
  if (peak > p.begin) add_phase((vp - vi) / a, path_, p.begin, accel);
  if (!flat.zero()) add_phase(flat / vp, path_ + up.fixed(32), peak, 0);
  if (peak > out) add_phase((vp - vo) / a, end - down.fixed(32), peak, -accel);
  path_ = end;
  if (p.next != kNone) {
    piece_ = p.next;
    return;
  }
  end_chain();
}

void FeedPlanner::add_phase(Real duration, std::uint64_t path, std::uint64_t speed,
                            std::int64_t accel) {
  if (state_ != State::kBusy) return;
  const FeedPhase* last = n_phases_ == chain_ ? nullptr : &w_.phases[n_phases_ - 1];
  const bool same = last != nullptr && accel == last->accel && (accel != 0 || last->speed == speed);
  if (!same) {
    if (n_phases_ == w_.phase_room) {
      state_ = State::kNoRoom;
      return;
    }
    w_.phases[n_phases_++] = {time_, path, speed, accel};
  }
  time_ += duration.fixed(32);
  if (time_ >> 62 != 0) state_ = State::kTooLong;
}

void FeedPlanner::end_chain() {
  if (state_ != State::kBusy) return;
  const std::uint32_t whole = FeedPath::whole(time_);
  const std::uint64_t rest = std::uint64_t{whole} << 32;
  if (rest < time_) time_ = rest;  // by as little as a chain may be late
  add_phase({}, path_, 0, 0);
  const std::uint64_t ticks =
      std::uint64_t{whole} + limits_.mean + w_.segments[segment_ - 1].dwell;
  if (ticks + ticks_ > kMostTicks) state_ = State::kTooLong;
  if (state_ != State::kBusy) return;
  ticks_ += static_cast<std::uint32_t>(ticks);
  chain_ = n_phases_;
  n_pieces_ = 0;
  stage_ = Stage::kSegment;
  if (segment_ == w_.n_segments) state_ = State::kDone;
}

}  // namespace trammel::sw
