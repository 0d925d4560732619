// SPDX-License-Identifier: MIT
//
// Survivors of a block that wait for a cutter of several triangles at once.
#if defined(CLIPSCOPE_BATCH_LANE_QUEUE_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_LANE_QUEUE_INL
#undef CLIPSCOPE_BATCH_LANE_QUEUE_INL
#else
#define CLIPSCOPE_BATCH_LANE_QUEUE_INL
#endif

#include <span>

#include "spaces/batch/classify-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// Finds the next kLanes survivors that need a cutter when the last ones have been handed out.
template <std::size_t kLanes>
class LaneQueue {
 public:
  // To be called before the survivors of another block.
  void forget() { filled_ = next_ = 0; }

  // The lane of survivor `at` of a block that has `count`. To be called for each survivor that
  // needs(at), in turn. cut(members): cuts those survivors, each in the lane of its place.
  template <class Needs, class Cut>
  HWY_INLINE std::size_t lane_of(std::size_t at, std::size_t count, Needs&& needs, Cut&& cut) {
    if (next_ == filled_) {
      std::size_t members[kLanes + 1];
      filled_ = next_ = 0;
      for (; at < count && filled_ < kLanes; ++at) {  // without a branch on what it needs
        members[filled_] = at;
        filled_ += needs(at);
      }
      cut(std::span<const std::size_t>(members, filled_));
    }
    return next_++;
  }

 private:
  std::size_t filled_ = 0, next_ = 0;  // lanes in use, lanes handed out
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
