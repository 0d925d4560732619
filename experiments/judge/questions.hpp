// SPDX-License-Identifier: GPL-3.0-or-later
//
// Questions: what a contestant's answers are asked, whatever it promises.
//
// A contestant is asked about whole batches: the batch as given, with its vertices rotated, scaled,
// with attributes that are constant, beside neighbours, again, and in another order. A guest that
// is a program is started once for each of these, a plug-in is sent one message.
//
// covers and contained are measured as promises are (promise.hpp), within the contestant's own
// bound; where it states none, within kChainUlps u M (spaces/clipper.hpp), what a chain of plane
// after plane keeps. Everything else holds to the bit, or does not.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// In this order they are printed.
enum class Question : std::uint8_t {
  total,              // an answer, with x, y and z that are finite; no crash, no time-out
  confined,           // |x| and |y| at most 1 and z in its range, to the bit
  contained,          // nothing is drawn outside of volume and triangle, within the bound
  covers,             // no visible part is lost, within the bound
  winding,            // the polygon is wound as the triangle is
  watertight,         // a neighbour across the first edge has the same vertices on that edge
  rotation,           // the same vertices whichever of the triangle's is first
  scale,              // the same for coordinates (or view-space lengths) times 2^8
  constants,          // an attribute that has one value at all vertices keeps it
  faithful,           // the right vertices, every number one of the two next to the exact one
  correctly_rounded,  // the right vertices, every number the float nearest to the exact one
  steady  // the same bits when asked again, alone, in another order (of a guest: see conduct.hpp)
};

inline constexpr std::size_t kQuestions = 12;
constexpr std::array<std::string_view, kQuestions> names_of(Question) {
  return {"total",    "confined", "contained", "covers",   "winding",           "watertight",
          "rotation", "scale",    "constants", "faithful", "correctly_rounded", "steady"};
}
inline std::string_view name_of(Question question) {
  return names_of(question)[static_cast<std::size_t>(question)];
}

class Questions {
 public:
  constexpr Questions() = default;
  constexpr Questions(std::initializer_list<Question> questions) {
    for (const Question q : questions) add(q);
  }
  static constexpr Questions all() {
    Questions all;
    all.bits_ = (1u << kQuestions) - 1;
    return all;
  }

  constexpr bool contains(Question q) const { return (bits_ >> static_cast<unsigned>(q) & 1) != 0; }
  constexpr void add(Question q) { bits_ |= 1u << static_cast<unsigned>(q); }
  constexpr void remove(Question q) { bits_ &= ~(1u << static_cast<unsigned>(q)); }
  constexpr bool has_any(const Questions& others) const { return (bits_ & others.bits_) != 0; }
  constexpr std::size_t size() const { return static_cast<std::size_t>(std::popcount(bits_)); }
  // In the order of the questions.
  std::vector<Question> list() const;

  friend bool operator==(const Questions&, const Questions&) = default;

 private:
  std::uint32_t bits_ = 0;
};

// What the contestant itself states. A guest states nothing.
Questions stated_by(const Contestant& contestant);

// What is asked of a contestant unless the user says: what it states; of a guest what a renderer
// can't do without.
Questions usually_asked(const Contestant& contestant);

struct BrokenPromise {
  Question question = Question::total;
  std::string reason;  // a sentence without its full stop
  double excess = 0;   // how many times beyond its threshold, > 1; infinity where it has none
};

// What was found on one primitive.
struct Examined {
  // Whether the bounds of covers and contained speak of it: its numbers stay in the format, and so
  // on (PromiseVerdict::outside_domain). Always true where neither was asked.
  bool in_domain = true;
  double ulps = 0;  // backward error, see PromiseCheck; 0 where it was not measured
  // Those of the questions asked that could be judged on this primitive. A primitive without an
  // answer is judged for `total` alone, and breaks it, asked or not.
  Questions judged = {};
  std::vector<BrokenPromise> violations = {};  // at most one for each question, in their order

  const BrokenPromise* violation(Question question) const;
};

// One for each primitive of the batch, in parallel.
//
// What can't be judged: watertight and scale where a coordinate leaves no room for it in the
// format (|x| in [2^-40, 2^40] or 0), watertight where the first edge lies in a plane (one side may
// keep nothing but the edge then), where one side draws nothing and in exact arithmetic; constants
// where every attribute is a clip distance; correctly_rounded but in float and against a frustum or
// in clip space; faithful in double-double.
//
// What watertight does not see: a vertex that one side has in the middle of the edge and the other
// has not, if the contestant is a guest. What lies on the edge is found by a mark in an attribute
// for our own clippers; a guest need not keep that, so its vertices are matched with those of the
// exact polygon, where it has as many.
//
// A guest may draw nothing of a triangle that has no area on screen: that is no loss to `covers`.
// Of attributes that are more than a contestant takes it is asked about the first.
//
// Pre-condition: triangles that the contestant takes and whose numbers are finite.
std::vector<Examined> examine(const Contestant& contestant, const Batch& batch,
                              const Questions& asked);
// The same where its answers to the batch as given are known.
std::vector<Examined> examine(const Contestant& contestant, const Batch& batch,
                              const Questions& asked, const Answers& given);

// What a contestant breaks of that which it states to the bit, on one triangle; empty if it keeps
// it. Pre-conditions: those of examine.
std::string broken_bits(const Contestant& contestant, const Batch& triangle);

}  // namespace clipscope::experiments
