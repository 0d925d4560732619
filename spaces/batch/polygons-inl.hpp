// SPDX-License-Identifier: MIT
//
// The polygons of a group of triangles while plane after plane cuts them: many at once, so that the
// work of one goes on while another waits, and without a branch for what a plane does to one.
//
// A polygon is a list of its corners, a byte for each: numbers that say to its owner what they are;
// and a list of their codes, which planes they are outside of. A shift turns both.
#if defined(CLIPSCOPE_BATCH_POLYGONS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_POLYGONS_INL
#undef CLIPSCOPE_BATCH_POLYGONS_INL
#else
#define CLIPSCOPE_BATCH_POLYGONS_INL
#endif

#include <bit>

#include "spaces/batch/cut-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// Up to kMost polygons of at most eight corners. Places in lists, and sizes, count bits: eight for
// each corner.
template <std::size_t kMost>
class Polygons {
  static_assert(kMost % 8 == 0 && kMost < 64);

 public:
  // Begins with so many whole triangles, whose corners are 0, 1 and 2. codes(i): those of the i-th.
  template <class F>
  HWY_INLINE void begin(std::size_t count, F&& codes) {
    count_ = count;
    given_up_ = any_ = 0;
    for (std::size_t i = 0; i < count; ++i) {
      codes_[i] = codes(i);
      any_ |= codes_[i];
      numbers_[i] = 0x020100;
      corners_[i] = first(kOnes, 3 * 8);
    }
  }

  // Cuts all by a plane, whose bit in the codes this is. cut(i): of a polygon with corners on both
  // sides. Of one that is all outside nothing is left.
  template <class F>
  HWY_INLINE void cut_by(int bit, F&& cut) {
    if ((any_ >> bit & kOnes) == 0) return;
    for (std::uint64_t rest = find_crossed(bit); rest != 0; rest &= rest - 1) {
      cut(static_cast<std::size_t>(std::countr_zero(rest)));
    }
  }

  // A polygon from its first corner inside a plane on; beyond the size anything.
  struct Turned {
    std::uint64_t numbers, codes;
    int size, kept;   // those inside are kept
    bool is_one_run;  // those outside; else nothing else holds

    HWY_INLINE std::size_t at(int place) const { return numbers >> place & 0xFF; }
    HWY_INLINE std::size_t first_in() const { return at(0); }
    HWY_INLINE std::size_t last_in() const { return at(kept - 8); }
    HWY_INLINE std::size_t first_out() const { return at(kept); }
    HWY_INLINE std::size_t last_out() const { return at(size - 8); }
  };
  // Pre-condition: it has corners on both sides.
  HWY_INLINE Turned turned(std::size_t i, int bit) const {
    const std::uint64_t corners = corners_[i], outside = codes_[i] >> bit & kOnes,
                        inside = corners ^ outside;
    const int size = 8 * std::popcount(corners), kept = 8 * std::popcount(inside);
    // Corners inside after one outside.
    const std::uint64_t enters = inside & (outside << 8 | outside >> (size - 8));
    const int begin = std::countr_zero(enters);
    return {turn(numbers_[i], begin, size), turn(codes_[i], begin, size), size, kept,
            (enters & (enters - 1)) == 0};
  }

  // Puts new corners, of so many bits, into the place of those outside.
  HWY_INLINE void replace(std::size_t i, const Turned& turned, std::uint64_t numbers,
                          std::uint64_t codes, int bits) {
    const int size = turned.kept + bits;
    if (HWY_UNLIKELY(size > kMostBits)) return give_up(i);
    numbers_[i] = first(turned.numbers, turned.kept) | numbers << turned.kept;
    codes_[i] = first(turned.codes, turned.kept) | codes << turned.kept;
    corners_[i] = kOnes >> (kMostBits - size);
  }

  // For good: no plane looks at it again.
  HWY_INLINE void give_up(std::size_t i) {
    given_up_ |= std::uint64_t{1} << i;
    codes_[i] = corners_[i] = 0;
  }
  HWY_INLINE bool is_given_up(std::size_t i) const { return (given_up_ >> i & 1) != 0; }

  HWY_INLINE int size(std::size_t i) const { return std::popcount(corners_[i]); }
  HWY_INLINE std::uint64_t numbers(std::size_t i) const { return numbers_[i]; }

 private:
  static constexpr std::uint64_t kOnes = 0x0101010101010101;
  static constexpr int kMostBits = 64;

  static HWY_INLINE std::uint64_t first(std::uint64_t list, int bits) {
    return list & ((std::uint64_t{1} << bits) - 1);
  }
  static HWY_INLINE std::uint64_t turn(std::uint64_t list, int begin, int size) {
    return list >> begin | list << 8 << (size - begin - 8);
  }

  // As bits.
  HWY_INLINE std::uint64_t find_crossed(int bit) {
    const hn::CappedTag<std::uint64_t, 8> d;
    const auto zero = hn::Zero(d);
    std::uint64_t crossed = 0;
    for (std::size_t i = 0; i < count_; i += hn::Lanes(d)) {
      const auto codes = hn::Load(d, codes_ + i), corners = hn::Load(d, corners_ + i);
      const auto outside = hn::And(hn::ShiftRightSame(codes, bit), hn::Set(d, kOnes));
      const auto gone = hn::Eq(outside, corners);
      hn::Store(hn::IfThenZeroElse(gone, codes), d, codes_ + i);
      hn::Store(hn::IfThenZeroElse(gone, corners), d, corners_ + i);
      crossed |= std::uint64_t{mask_bits(d, hn::AndNot(gone, hn::Ne(outside, zero)))} << i;
    }
    return first(crossed, static_cast<int>(count_));  // beyond there is what was there before
  }

  std::size_t count_ = 0;
  // Beyond the size of a list there are zeros. corners: ones in all bytes.
  HWY_ALIGN std::uint64_t numbers_[kMost] = {}, codes_[kMost] = {}, corners_[kMost] = {};
  std::uint64_t any_ = 0, given_up_ = 0;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
