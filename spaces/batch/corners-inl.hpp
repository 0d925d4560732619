// SPDX-License-Identifier: MIT
//
// Several planes, cut from a triangle's three own vertices, as in exact_corners.hpp: of as many
// triangles at once as a register has lanes for doubles.
//
// A polygon is a list of lines, in order: corner i is where line i goes over to line i + 1. Of each
// corner there is a code, of the planes that it is outside of, found when the corner is made. Both
// lists are eight bytes in a lane, so that shifts turn them and a mask finds the one run of corners
// outside a plane: there is no branch for a triangle, and the corners that take the place of those
// are computed for all lanes at once. All planes that cut one of them are gone through; to sort
// triangles by their planes, so that these are fewer, gains nothing: loops then end unforeseen.
//
// A corner's side of a plane is certain if the determinant is larger than its bound; a determinant
// of 0 is handed back, too, and so is a polygon of more than eight corners.
//
// Lemma (sides). The bound of exact_lines.hpp is 10 u M in clip space, M being the sum of the
// magnitudes of the determinant's six products. With N of a line the sum of the magnitudes of its
// entries, M <= N_a N_b N_c; each N has two roundings and their products two more, which 12 u
// covers.
#if defined(CLIPSCOPE_BATCH_CORNERS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef CLIPSCOPE_BATCH_CORNERS_INL
#undef CLIPSCOPE_BATCH_CORNERS_INL
#else
#define CLIPSCOPE_BATCH_CORNERS_INL
#endif

#include "spaces/batch/cut-inl.hpp"
#include "spaces/batch/error_bounds.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

// What is left of triangles that several planes cut. Lines 0 to 2 are a triangle's edges, each
// opposite to its vertex, the others planes, 3 and on, in the order of `kAllPlanes`.
// V: of the vertices, Plane: CodePlane, or ViewCodePlane with vertices (x, y, z, …).
template <bool kCertain, class V, class Plane>
class CornerLanes {
  using D = hn::CappedTag<double, 8>;
  using DU = hn::RebindToUnsigned<D>;
  using Vec = hn::Vec<D>;
  using Bytes = hn::Vec<DU>;
  using Mask = hn::Mask<DU>;

 public:
  static constexpr std::size_t kLanes = hn::MaxLanes(D());
  static constexpr std::size_t kMostCorners = 8;

  CornerLanes() {
    for (int e = 0; e < 3; ++e) {
      for (int v = 0; v < 3; ++v) std::fill_n(lines_[e][v], 8, v == e ? 1.0 : 0.0);
    }
  }

  // Cuts triangles by the planes that some of their vertices are outside of. position(lane, v):
  // where x y z w of a vertex lie, for lanes below the count.
  template <class F>
  HWY_NOINLINE void cut(const std::array<Plane, kPlanes>& planes, std::size_t count, F&& position) {
    load_positions_of(count, position);
    set_triangles(planes);
    for (int i = 0; i < used_count_; ++i) cut_by(i);
    set_corners();
  }

  // A corner that was made: lambda = line `from` x line `to`, see `barycentric::meet`, and the
  // magnitudes of its terms.
  struct Corner {
    double lambda[3], magnitude[3];
    int from, to;
  };
  HWY_INLINE Corner corner(std::size_t lane, int i) const {
    Corner r{{}, {}, from(lane, i), to(lane, i)};
    for (int v = 0; v < 3; ++v) {
      const int j = (v + 1) % 3, k = (v + 2) % 3;
      r.lambda[v] = lambda_[i][v][lane];
      r.magnitude[v] = std::abs(lines_[r.from][j][lane] * lines_[r.to][k][lane]) +
                       std::abs(lines_[r.from][k][lane] * lines_[r.to][j][lane]);
    }
    return r;
  }

  // Of a lane: whether all sides were certain; else nothing else holds.
  HWY_INLINE bool is_certain(std::size_t lane) const { return (given_up_bits_ >> lane & 1) == 0; }
  HWY_INLINE int size(std::size_t lane) const { return static_cast<int>(sizes_[lane]) / 8; }
  // A bit for each corner that is no vertex of the triangle: 8 i + 7 for corner i.
  HWY_INLINE std::uint64_t made(std::size_t lane) const { return made_[lane]; }
  // The line that goes over to the next at a corner, and that one.
  HWY_INLINE int from(std::size_t lane, int i) const { return byte(from_bytes_[lane], i); }
  HWY_INLINE int to(std::size_t lane, int i) const { return byte(to_bytes_[lane], i); }

  // The vertex of the triangle that a corner is, or -1.
  HWY_INLINE int own(std::size_t lane, int i) const {
    return (made_[lane] >> (8 * i + 7) & 1) != 0 ? -1 : own_of(lane, i);
  }
  // The same where it is known to be one; a number below 3 in any case.
  HWY_INLINE int own_of(std::size_t lane, int i) const {
    static constexpr std::uint8_t kOwn[3 + kPlanes] = {2, 0, 1};  // by the line that ends there
    return kOwn[from(lane, i)];
  }

  // Of a corner that was made: lambda = line `from` x line `to`, see `barycentric::meet`; one over
  // its sum, and a bound of the relative error of a quotient for the roundings of both. Whether
  // that holds.
  HWY_INLINE double lambda(std::size_t lane, int i, int v) const { return lambda_[i][v][lane]; }
  HWY_INLINE double reciprocal(std::size_t lane, int i) const { return reciprocal_[i][lane]; }
  HWY_INLINE double error(std::size_t lane, int i) const { return error_[i][lane]; }
  HWY_INLINE bool has_sum(std::size_t lane, int i) const { return (has_sum_[i] >> lane & 1) != 0; }

 private:
  static constexpr D kD{};
  static constexpr DU kDU{};
  static constexpr std::uint64_t kOnes = 0x0101010101010101;

  static HWY_INLINE int byte(std::uint64_t bytes, int i) {
    return static_cast<int>(bytes >> (8 * i) & 0xFF);
  }
  static HWY_INLINE Bytes same(std::uint64_t bytes) { return hn::Set(kDU, bytes); }
  // Ones in so many bits, less than 64, from the lowest on.
  static HWY_INLINE Bytes lowest(Bytes bits) {
    return hn::Not(hn::Shl(same(~std::uint64_t{0}), bits));
  }
  static HWY_INLINE Mask as_bytes(hn::Mask<D> m) { return hn::RebindMask(kDU, m); }

  template <class F>
  HWY_INLINE void load_positions_of(std::size_t count, F&& position) {
    static constexpr V kNothing[4] = {0, 0, 0, 0};
    const auto at = [&](std::size_t lane, int v) {
      return lane < count ? position(lane, v) : kNothing;
    };
    for (int v = 0; v < 3; ++v) {
      if constexpr (std::is_same_v<V, float>) {
        const hn::CappedTag<float, kLanes <= 4 ? 4 : 8> d;
        const auto p = load_positions_at(d, [&](std::size_t lane) { return at(lane, v); });
        hn::Store(p.x, d, positions_[v][0]);
        hn::Store(p.y, d, positions_[v][1]);
        hn::Store(p.z, d, positions_[v][2]);
        hn::Store(p.w, d, positions_[v][3]);
      } else {
        for (std::size_t lane = 0; lane < kLanes; ++lane) {
          for (int c = 0; c < 4; ++c) positions_[v][c][lane] = at(lane, v)[c];
        }
      }
    }
  }

  // A plane's weights: the distance is of_c c + of_other o + constant, of coordinates c and o.
  struct Weights {
    Vec of_c, of_other, constant;
    int axis, other;
  };
  static HWY_INLINE Vec in_all_lanes(float weight) {
    return hn::Set(kD, static_cast<double>(weight));
  }
  static HWY_INLINE Weights weights_of(const CodePlane& p) {
    return {in_all_lanes(p.c_weight), in_all_lanes(p.w_weight), hn::Zero(kD), p.axis, 3};
  }
  static HWY_INLINE Weights weights_of(const ViewCodePlane& p) {
    return {in_all_lanes(p.own), in_all_lanes(p.z_weight), in_all_lanes(p.constant), p.axis, 2};
  }
  HWY_INLINE Vec distance_of(const Weights& w, int v) const {
    const Vec sum = hn::Add(hn::Mul(w.of_c, load(kD, positions_[v][w.axis])),
                            hn::Mul(w.of_other, load(kD, positions_[v][w.other])));
    return hn::Add(sum, w.constant);
  }

  // The lines and the whole triangles.
  HWY_INLINE void set_triangles(const std::array<Plane, kPlanes>& planes) {
    Bytes codes = hn::Zero(kDU);  // no store can be taken for one to these
    Mask given_up = hn::MaskFromVec(codes);
    int used = 0;
    for (std::size_t p = 0; p < kPlanes; ++p) {
      const Weights weights = weights_of(planes[p]);
      Vec norm = hn::Zero(kD);
      auto on_plane = hn::MaskFromVec(norm), outside = on_plane;
      for (int v = 0; v < 3; ++v) {
        const Vec d = distance_of(weights, v);
        const auto is_out = hn::Lt(d, hn::Zero(kD));
        hn::Store(d, kD, lines_[3 + p][v]);
        norm = hn::Add(norm, hn::Abs(d));
        on_plane = hn::Or(on_plane, hn::Eq(d, hn::Zero(kD)));
        outside = hn::Or(outside, is_out);
        codes = hn::Or(codes,
                       hn::IfThenElseZero(as_bytes(is_out), same(std::uint64_t{1} << (8 * v + p))));
      }
      hn::Store(norm, kD, norms_[p]);
      given_up = hn::Or(given_up, as_bytes(hn::And(on_plane, outside)));
      crosses_[p] = as_bytes(outside);
      used_[used] = static_cast<int>(p);  // without a branch
      used += !hn::AllFalse(kD, outside);
    }
    codes_ = codes;
    given_up_ = given_up;
    used_count_ = used;
    from_ = same(0x000201);  // vertex 0 is where edge 1 goes over to edge 2
    size_ = same(24);
  }

  // By the plane at a place in `used_`.
  HWY_INLINE void cut_by(int place) {
    const int p = used_[place];
    const Bytes column = hn::And(hn::ShiftRightSame(codes_, p), same(kOnes));
    const Mask crossed = hn::Ne(column, hn::Zero(kDU));
    if (hn::AllFalse(kDU, crossed)) return;
    const Bytes corners = hn::And(lowest_of_size(size_), same(kOnes));
    const Mask gone = hn::And(crossed, hn::Eq(column, corners));
    // Corners whose predecessor is outside.
    const Bytes after = hn::And(
        hn::Or(hn::ShiftLeft<8>(column), hn::Shr(column, hn::Sub(size_, same(8)))), corners);
    const Bytes leaves = hn::AndNot(after, column), enters = hn::AndNot(column, after);
    const Mask torn = hn::Ne(hn::And(leaves, hn::Sub(leaves, same(1))), hn::Zero(kDU));
    // Bits before the first corner inside after one outside, and those of all that are inside.
    const Bytes first = hn::PopulationCount(hn::Sub(enters, same(1))),
                kept = hn::ShiftLeft<3>(hn::PopulationCount(hn::AndNot(column, corners)));
    const Mask left = hn::Or(torn, hn::Eq(kept, same(8 * (kMostCorners - 1))));
    given_up_ = hn::Or(given_up_, hn::And(crossed, left));
    const Mask active = hn::AndNot(hn::Or(gone, left), crossed);
    const Bytes from = turned(from_, first, size_), next = hn::Add(kept, same(8)),
                size = hn::Add(kept, same(16));
    Mask unknown = torn;
    const Bytes leave = code_of(place, lowest_byte(hn::Shr(from, kept), active), false, unknown),
                enter = code_of(place, lowest_byte(from, active), true, unknown);
    given_up_ = hn::Or(given_up_, hn::And(active, unknown));
    const Bytes codes = hn::Or(hn::And(turned(codes_, first, size_), lowest(kept)),
                               hn::Or(hn::Shl(leave, kept), hn::Shl(enter, next)));
    const Bytes lines =
        hn::Or(hn::And(from, lowest(next)), hn::Shl(same(static_cast<std::uint64_t>(3 + p)), next));
    const Bytes start = first_place(column, first, next), whole = lowest_of_size(size);
    codes_ = hn::IfThenElse(active, hn::And(turned(codes, start, size), whole),
                            hn::IfThenZeroElse(gone, codes_));
    from_ = hn::IfThenElse(active, hn::And(turned(lines, start, size), whole), from_);
    size_ = hn::IfThenElse(active, size, hn::IfThenZeroElse(gone, size_));
  }

  // Where the scalar clipper's polygon begins in a list from the first corner inside on, with the
  // new ones behind: at the first corner, or, if that is outside, where the inside is entered.
  HWY_INLINE Bytes first_place(Bytes column, Bytes first, Bytes next) const {
    const Mask is_out = hn::Ne(hn::And(column, same(1)), hn::Zero(kDU)),
               is_first = hn::Eq(first, hn::Zero(kDU));
    return hn::IfThenElse(is_out, next, hn::IfThenZeroElse(is_first, hn::Sub(size_, first)));
  }

  static HWY_INLINE Bytes lowest_byte(Bytes bytes, Mask active) {
    return hn::IfThenElseZero(active, hn::And(bytes, same(0xFF)));
  }

  // The same, of up to 64 bits.
  static HWY_INLINE Bytes lowest_of_size(Bytes bits) {
    return hn::Not(hn::Shl(same(~std::uint64_t{0xFF}), hn::Sub(bits, same(8))));
  }

  // A list of so many bits, from the first on, going round.
  static HWY_INLINE Bytes turned(Bytes list, Bytes first, Bytes size) {
    const Bytes rest = hn::Sub(hn::Sub(size, first), same(8));
    return hn::Or(hn::Shr(list, first), hn::Shl(hn::ShiftLeft<8>(list), rest));
  }

  // Numbers at the three vertices.
  struct Row {
    Vec at[3];
  };
  static HWY_INLINE Row cross(const Row& a, const Row& b) {
    const auto minor = [&](int j, int k) {
      return hn::Sub(hn::Mul(a.at[j], b.at[k]), hn::Mul(a.at[k], b.at[j]));
    };
    return {minor(1, 2), minor(2, 0), minor(0, 1)};
  }
  static HWY_INLINE Vec dot(const Row& a, const Row& b) {
    if constexpr (kCertain) {
      return hn::MulAdd(a.at[2], b.at[2], hn::MulAdd(a.at[1], b.at[1], hn::Mul(a.at[0], b.at[0])));
    } else {
      return hn::Add(hn::Add(hn::Mul(a.at[0], b.at[0]), hn::Mul(a.at[1], b.at[1])),
                     hn::Mul(a.at[2], b.at[2]));
    }
  }

  using Index = hn::Vec<hn::RebindToSigned<D>>;
  HWY_INLINE Row row_of(Bytes line) const {
    const hn::RebindToSigned<D> di;
    const Bytes eights = hn::ShiftLeft<3>(line), first = hn::Add(eights, hn::ShiftLeft<1>(eights));
    const Index at = hn::Add(hn::BitCast(di, first), hn::Iota(di, 0));
    return {hn::GatherIndex(kD, lines_[0][0], at), hn::GatherIndex(kD, lines_[0][1], at),
            hn::GatherIndex(kD, lines_[0][2], at)};
  }
  HWY_INLINE Row row_of_plane(int p) const {
    return {hn::Load(kD, lines_[3 + p][0]), hn::Load(kD, lines_[3 + p][1]),
            hn::Load(kD, lines_[3 + p][2])};
  }
  // N of a line.
  static HWY_INLINE Vec norm(const Row& a) {
    return hn::Add(hn::Add(hn::Abs(a.at[0]), hn::Abs(a.at[1])), hn::Abs(a.at[2]));
  }

  // The code of the meeting of a plane and a line, of the planes after it; where that is not
  // certain is added to `unknown`.
  HWY_INLINE Bytes code_of(int place, Bytes line, bool enters, Mask& unknown) const {
    const int p = used_[place];
    const Row a = row_of(line), b = row_of_plane(p);
    const Row lambda = enters ? cross(b, a) : cross(a, b);
    const Vec bound = hn::Mul(hn::Set(kD, kSideError), hn::Mul(norm(a), hn::Load(kD, norms_[p])));
    Bytes code = hn::Zero(kDU);
    for (int i = place + 1; i < used_count_; ++i) {
      const int q = used_[i];
      const Vec d = dot(lambda, row_of_plane(q));
      const Vec error = kCertain ? hn::Mul(bound, hn::Load(kD, norms_[q])) : hn::Zero(kD);
      unknown = hn::Or(unknown, hn::And(as_bytes(hn::Le(hn::Abs(d), error)), crosses_[q]));
      const Mask outside = hn::And(as_bytes(hn::Lt(d, hn::Zero(kD))), crosses_[q]);
      code = hn::Or(code, hn::IfThenElseZero(outside, same(std::uint64_t{1} << q)));
    }
    return code;
  }

  HWY_INLINE void set_corners() {
    const Bytes to = hn::Or(hn::ShiftRight<8>(from_),
                            hn::Shl(hn::And(from_, same(0xFF)), hn::Sub(size_, same(8))));
    // Adding 0x7D to a line makes bit 7 a plane's.
    const auto is_plane = [&](Bytes lines) { return hn::Add(lines, same(0x7D * kOnes)); };
    const Bytes made = hn::And(
        hn::And(hn::Or(is_plane(from_), is_plane(to)), lowest_of_size(size_)), same(0x80 * kOnes));
    hn::Store(made, kDU, made_);
    hn::Store(from_, kDU, from_bytes_);
    hn::Store(to, kDU, to_bytes_);
    hn::Store(size_, kDU, sizes_);
    given_up_bits_ = mask_bits(kDU, given_up_);
    const int most = static_cast<int>(*std::max_element(sizes_, sizes_ + kLanes)) / 8;
    Row line = row_of(hn::And(from_, same(0xFF)));
    Bytes rest = to;
    for (int i = 0; i < most; ++i) {
      const Row next = row_of(hn::And(rest, same(0xFF)));
      set_corner(i, line, next);
      line = next;
      rest = hn::ShiftRight<8>(rest);
    }
  }

  HWY_INLINE void set_corner(int i, const Row& from, const Row& to) {
    const Row lambda = cross(from, to);
    const Vec sum = hn::Add(hn::Add(lambda.at[0], lambda.at[1]), lambda.at[2]),
              reciprocal = hn::Div(hn::Set(kD, 1.0), sum),
              error = hn::Mul(hn::Set(kD, kSideError), hn::Mul(norm(from), norm(to)));
    for (int v = 0; v < 3; ++v) hn::Store(lambda.at[v], kD, lambda_[i][v]);
    hn::Store(reciprocal, kD, reciprocal_[i]);
    const Vec relative = hn::Mul(hn::Mul(error, reciprocal), hn::Set(kD, kMeanError));
    hn::Store(hn::Add(relative, hn::Set(kD, kMeanRoundings)), kD, error_[i]);
    const Vec least = hn::Mul(hn::Set(kD, barycentric::kDivisorCertainty), error);
    has_sum_[i] = mask_bits(kD, hn::Gt(sum, least));
  }

  // [vertex][coordinate][lane] and [line][vertex][lane]; N of the lines.
  HWY_ALIGN V positions_[3][4][8];
  HWY_ALIGN double lines_[3 + kPlanes][3][8];
  HWY_ALIGN double norms_[kPlanes][8];
  Bytes codes_, from_;
  Bytes size_;  // bits: eight for each corner
  Mask given_up_;
  HWY_ALIGN std::uint64_t from_bytes_[8], to_bytes_[8], sizes_[8], made_[8];
  HWY_ALIGN double lambda_[kMostCorners][3][8], reciprocal_[kMostCorners][8],
      error_[kMostCorners][8];
  unsigned has_sum_[kMostCorners] = {};
  unsigned given_up_bits_ = 0;
  Mask crosses_[kPlanes];  // some vertex is outside of it; no corner is outside another
  // Those of any triangle.
  int used_[kPlanes + 1], used_count_ = 0;
};

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
