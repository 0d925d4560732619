// SPDX-License-Identifier: MIT
//
// Triangles that several planes cut, plane after plane (Sutherland-Hodgman), a group of them at
// once.
#if defined(CLIPSCOPE_BATCH_PLANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_PLANES_INL
#undef CLIPSCOPE_BATCH_PLANES_INL
#else
#define CLIPSCOPE_BATCH_PLANES_INL
#endif

#include "spaces/batch/polygons-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// In T, float or double, in a space with its limits and planes, with the bits of `from_nearer_end`
// (spaces/cut.hpp). A polygon of more than eight corners is handed back, and so is one with several
// runs of corners outside a plane.
template <class T, class S, class Limits, class Plane>
class PlaneAfterPlane {
 public:
  // Of a group: many, so that loops over them end as foreseen, but their pools fit into a cache of
  // first level.
  static constexpr std::size_t kTriangles = S::kWidth > 8                ? 8
                                            : sizeof(T) == sizeof(float) ? 32
                                                                         : 16;

  PlaneAfterPlane(const S& shape, const Limits& limits, const std::array<Plane, kPlanes>& planes)
      : shape_(shape), limits_(limits), planes_(planes) {}

  // Cuts so many triangles. at(i, v): where a vertex of the i-th lies.
  template <class F>
  HWY_NOINLINE void cut(std::size_t count, F&& at) {
    polygons_.begin(count, [&](std::size_t i) {
      std::uint64_t codes = 0;
      for (int v = 0; v < 3; ++v) codes |= load_vertex(at(i, v), pools_[i].vertex[v]) << 8 * v;
      return codes;
    });
    for (std::size_t p = 0; p < kPlanes; ++p) {
      polygons_.cut_by(planes_[p].bit, [&](std::size_t i) { cut_by(p, i); });
    }
  }

  // What is left of the i-th: vertices written to `out`, or kGiveUp.
  template <class To>
  HWY_INLINE int write(std::size_t i, To* out) const {
    if (polygons_.is_given_up(i)) return kGiveUp;
    const int size = polygons_.size(i);
    std::uint64_t numbers = polygons_.numbers(i);
    int kept = 0;
    for_each_corner(size, [&](int corner) {
      const T* const v = pools_[i].vertex[numbers & 0xFF].value();
      copy_vertex(shape_, v, out + static_cast<std::size_t>(kept) * shape_.floats());
      kept += static_cast<int>(corner < size && v[3] > 0);
      numbers >>= 8;
    });
    return kept < 3 ? 0 : kept;
  }

 private:
  static constexpr std::size_t kFloats = 8 + std::max<std::size_t>(8, S::kWidth);
  // A vertex: its distances, which have their planes' bits as places, and what it is made of.
  struct Vertex {
    HWY_ALIGN T all[kFloats];

    T* value() { return all + 8; }
    const T* value() const { return all + 8; }
  };
  // The triangle's vertices, and two for each plane: where edges leave its inside and enter it.
  struct Pool {
    Vertex vertex[3 + 2 * kPlanes];
  };

  using D8 = hn::CappedTag<T, 8>;
  // Over all of a vertex.
  using D = hn::CappedTag<T, kFloats == 16 ? 16 : 8>;

  // Returns the code.
  template <class V>
  HWY_INLINE std::uint64_t load_vertex(const V* v, Vertex& to) const {
    if constexpr (S::kLoadsInPlace) {
      const LanesOf<T, S> d;
      for (std::size_t i = 0; i < S::kWidth; i += hn::Lanes(d)) {
        hn::Store(load(d, v + i), d, to.value() + i);
      }
    } else {
      std::copy_n(v, shape_.floats(), to.value());
    }
    std::fill(to.value() + shape_.floats(), std::end(to.all), T(0));
    return code_of([&](std::size_t i) {
      const auto distance = distances(D8(), limits_, v, i);
      hn::Store(distance, D8(), to.all + i);
      return distance;
    });
  }

  // The planes that distances are outside of. distance(i): those in places i, i + 1, …
  template <class F>
  static HWY_INLINE std::uint64_t code_of(F&& distance) {
    std::uint64_t code = 0;
    for (std::size_t i = 0; i < 8; i += hn::Lanes(D8())) {
      code |= std::uint64_t{mask_bits(D8(), hn::Lt(distance(i), hn::Zero(D8())))} << i;
    }
    return code;
  }

  // A polygon by plane p.
  HWY_INLINE void cut_by(std::size_t p, std::size_t i) {
    const int bit = planes_[p].bit;
    const auto turned = polygons_.turned(i, bit);
    if (HWY_UNLIKELY(!turned.is_one_run)) return polygons_.give_up(i);
    Vertex* const pool = pools_[i].vertex;
    std::uint64_t numbers = 0, codes = 0;
    int bits = 0;
    const auto add = [&](const Vertex& in, const Vertex& out, std::size_t number) {
      if (in.all[bit] == 0) return;  // the end inside is the meeting
      codes |= meet(bit, in, out, pool[number]) << bits;
      numbers |= std::uint64_t{number} << bits;
      bits += 8;
    };
    add(pool[turned.last_in()], pool[turned.first_out()], 3 + 2 * p);
    add(pool[turned.first_in()], pool[turned.last_out()], 4 + 2 * p);
    polygons_.replace(i, turned, numbers, codes, bits);
  }

  // The vertex where an edge meets a plane, from the end nearer to it; its code. Both ends are
  // loaded and then blended: which is nearer can't be predicted, and pointers that wait for it
  // would make the loads wait. Pre-condition: the distance of `in` is positive, that of `out`
  // negative.
  HWY_INLINE std::uint64_t meet(int bit, const Vertex& in, const Vertex& out, Vertex& to) const {
    const D d;
    const T d_in = in.all[bit], beyond = -out.all[bit];
    const auto is_outside = hn::Lt(hn::Set(d, beyond), hn::Set(d, d_in));
    const auto t = hn::Set(d, std::min(d_in, beyond) / (d_in + beyond));
    for (std::size_t i = 0; i < 8 + std::max<std::size_t>(8, shape_.width()); i += hn::Lanes(d)) {
      const auto v_in = hn::Load(d, in.all + i), v_out = hn::Load(d, out.all + i);
      const auto a = hn::IfThenElse(is_outside, v_out, v_in),
                 b = hn::IfThenElse(is_outside, v_in, v_out);
      hn::Store(hn::Add(a, hn::Mul(t, hn::Sub(b, a))), d, to.all + i);
    }
    return code_of([&](std::size_t i) { return hn::Load(D8(), to.all + i); });
  }

  const S& shape_;
  const Limits& limits_;
  const std::array<Plane, kPlanes>& planes_;
  Pool pools_[kTriangles];
  Polygons<kTriangles> polygons_;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
