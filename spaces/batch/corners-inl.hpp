// SPDX-License-Identifier: MIT
//
// Several planes, cut from a triangle's three own vertices: as in exact_corners.hpp, with corners
// as numbers in a list. A corner's side of a plane is certain if the determinant is larger than its
// bound, of exact_lines.hpp; a determinant of 0 is handed back, too.
#if defined(CLIPSCOPE_BATCH_CORNERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_CORNERS_INL
#undef CLIPSCOPE_BATCH_CORNERS_INL
#else
#define CLIPSCOPE_BATCH_CORNERS_INL
#endif

#include "spaces/batch/cut-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// What is left of a triangle that several planes cut: corners, in order. Lines 0 to 2 are the
// triangle's edges, each opposite to its vertex, the others planes, 3 and on, as they are listed.
// kFromFirst: the polygon begins where the scalar clipper's does, which goes round from the first
// corner.
template <bool kCertain, bool kFromFirst = false>
class Corners {
 public:
  // lambda = line `from` x line `to`, see `barycentric::meet`.
  struct Corner {
    double lambda[3], magnitude[3];
    std::uint8_t from, to;
  };

  Corners() {
    static constexpr Corner kVertices[3] = {
        {{1, 0, 0}, {1, 0, 0}, 1, 2}, {{0, 1, 0}, {0, 1, 0}, 2, 0}, {{0, 0, 1}, {0, 0, 1}, 0, 1}};
    static constexpr double kEdges[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    std::memcpy(corners_, kVertices, sizeof kVertices);
    std::memcpy(lines_, kEdges, sizeof kEdges);
  }

  // Cuts by the planes that have a bit in s.any. True if all sides were certain, and the corners
  // outside each plane were one run.
  template <class Plane, class V>
  HWY_INLINE bool cut(const std::array<Plane, kPlanes>& planes, const Straddler<V>& s) {
    int cutting[kPlanes], count = 0;  // found without a branch
    for (int i = 0; i < kPlanes; ++i) {
      cutting[count] = i;
      count += s.any >> planes[static_cast<std::size_t>(i)].bit & 1;
    }
    for (const int i : std::span(cutting, count)) {
      double* const row = lines_[3 + i];
      for (int v = 0; v < 3; ++v) {
        row[v] = distance<double>(planes[static_cast<std::size_t>(i)], s.vertex[v]);
      }
      if (!cut_by(3 + i, i == cutting[0] ? vertex_sides(row) : corner_sides(row))) return false;
    }
    return true;
  }

  const List& list() const { return list_; }
  // The corner with that number in the list; the triangle's vertices have numbers below 3.
  const Corner& operator[](int number) const { return corners_[number]; }

 private:
  // The corners outside a plane, and those whose side is certain.
  struct Sides {
    unsigned outside = 0, decided = 0;

    HWY_INLINE void add(int i, double d, double error) {
      outside |= static_cast<unsigned>(d < 0) << i;
      decided |= static_cast<unsigned>(std::abs(d) > error) << i;
    }
  };

  // The sides of the triangle's own vertices, whose distances are exact in sign.
  static HWY_INLINE Sides vertex_sides(const double row[3]) {
    Sides r;
    for (int i = 0; i < 3; ++i) r.add(i, row[i], 0);
    return r;
  }

  HWY_INLINE Sides corner_sides(const double row[3]) const {
    Sides r;
    for_each_place(list_, [&](int i) {
      const Corner& c = corners_[list_.at(i)];
      const double d = c.lambda[0] * row[0] + c.lambda[1] * row[1] + c.lambda[2] * row[2];
      double error = 0;
      if constexpr (kCertain) {
        error = 10 * 0x1p-53 *
                (c.magnitude[0] * std::abs(row[0]) + c.magnitude[1] * std::abs(row[1]) +
                 c.magnitude[2] * std::abs(row[2]));
      }
      r.add(i, d, error);
    });
    return r;
  }

  HWY_INLINE bool cut_by(int line, const Sides& sides) {
    const unsigned all = (1u << list_.size) - 1, outside = sides.outside & all;
    if ((sides.decided & all) != all) return false;
    return cut_list(outside, list_, [&](const Crossing& crossing, List& r) {
      add_corner(corners_[list_.at(crossing.last_in)].to, line, r);
      add_corner(line, corners_[list_.at(crossing.first_in)].from, r);
      if constexpr (kFromFirst) r = r.from(first_place(outside, crossing, r));
    });
  }

  // Where a list from `first_in` on, with the new corners behind, has the first corner; if that is
  // outside, the one where the inside is entered.
  HWY_INLINE int first_place(unsigned outside, const Crossing& crossing, const List& list) const {
    if ((outside & 1) != 0) return list.size - 1;
    return crossing.first_in == 0 ? 0 : list_.size - crossing.first_in;
  }

  HWY_INLINE void add_corner(int from, int to, List& list) {
    const double *a = lines_[from], *b = lines_[to];
    Corner& c = corners_[size_];
    const auto set = [&](int i, int j, int k) {
      const double first = a[j] * b[k], second = a[k] * b[j];
      c.lambda[i] = first - second;
      c.magnitude[i] = std::abs(first) + std::abs(second);
    };
    set(0, 1, 2);
    set(1, 2, 0);
    set(2, 0, 1);
    c.from = static_cast<std::uint8_t>(from);
    c.to = static_cast<std::uint8_t>(to);
    list.add(size_++);
  }

  // Beyond `size_` and the lines of planes that cut, nothing is set.
  Corner corners_[3 + 2 * kPlanes];
  double lines_[3 + kPlanes][3];
  int size_ = 3;
  List list_ = kTriangle;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
