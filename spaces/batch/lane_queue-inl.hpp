// SPDX-License-Identifier: MIT
//
// Survivors of a block that wait for a cutter of several triangles at once.
#if defined(CLIPSCOPE_BATCH_LANE_QUEUE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_LANE_QUEUE_INL
#undef CLIPSCOPE_BATCH_LANE_QUEUE_INL
#else
#define CLIPSCOPE_BATCH_LANE_QUEUE_INL
#endif

#include <bit>
#include <span>

#include "spaces/batch/classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// Some of a block's survivors, as bits.
struct Choice {
  std::uint64_t bits[kMostBlock / 64] = {};
};

// Hands out survivors of a block, in turn, each with its lane among the next kLanes that are cut.
template <std::size_t kLanes>
class LaneQueue {
 public:
  // Those of another block.
  void begin(const Choice& choice) {
    rest_ = choice;
    word_ = 0;
    filled_ = next_ = 0;
  }

  // The lane of the next one. cut(members): cuts those survivors, each in the lane of its place.
  template <class Cut>
  HWY_INLINE std::size_t next(Cut&& cut) {
    if (HWY_UNLIKELY(next_ == filled_)) cut(refill());
    return next_++;
  }

 private:
  // The next ones.
  HWY_INLINE std::span<const std::size_t> refill() {
    std::size_t filled = 0;
    for (; word_ < std::size(rest_.bits); ++word_) {
      std::uint64_t bits = rest_.bits[word_];
      for (; bits != 0 && filled < kLanes; bits &= bits - 1) {
        members_[filled++] = 64 * word_ + static_cast<std::size_t>(std::countr_zero(bits));
      }
      rest_.bits[word_] = bits;
      if (filled == kLanes) break;
    }
    filled_ = filled;
    next_ = 0;
    return {members_, filled};
  }

  Choice rest_;
  std::size_t word_ = 0;  // of the bits
  std::size_t members_[kLanes];
  std::size_t filled_ = 0, next_ = 0;  // lanes in use, lanes handed out
};

// Whether one plane cuts, and nothing else is the matter.
HWY_INLINE bool is_one_plane(unsigned any) {
  return (any & kPlaneBits) != 0 && (any & (any - 1)) == 0;
}

// The survivors that are to be cut: by one plane, and others.
struct Cuts {
  Choice one, other;

  HWY_INLINE explicit Cuts(const Survivors& survivors) {
    const hn::CappedTag<std::uint8_t, 64> d;
    const auto zero = hn::Zero(d);
    const auto store = [&](Choice& to, std::size_t i, auto mask) {
      hn::StoreMaskBits(d, mask, reinterpret_cast<std::uint8_t*>(to.bits) + i / 8);
    };
    for (std::size_t i = 0; i < survivors.count; i += hn::Lanes(d)) {
      const auto any = hn::LoadU(d, survivors.any + i);
      const auto is_one = hn::And(hn::Eq(hn::And(any, hn::Sub(any, hn::Set(d, 1))), zero),
                                  hn::Ne(hn::And(any, hn::Set(d, kPlaneBits)), zero));
      store(one, i, is_one);
      store(other, i, hn::AndNot(is_one, hn::Ne(any, zero)));
    }
    trim(one, survivors.count);
    trim(other, survivors.count);
  }

 private:
  // Beyond the last survivor there is whatever was there before.
  static void trim(Choice& choice, std::size_t count) {
    if (count % 64 != 0) choice.bits[count / 64] &= (std::uint64_t{1} << count % 64) - 1;
  }
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
