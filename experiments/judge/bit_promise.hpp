// SPDX-License-Identifier: GPL-3.0-or-later
//
// Does a contestant keep to the bit what its answers to a batch say (questions.hpp): total,
// confined, watertight, the same when the triangle is rotated or scaled, keeping what is constant,
// steady?
//
// The contestant is asked about the batch's variants (variants.hpp) when an object is made, each
// whole batch once; of a guest those that are clipped against the same volume are one batch, so
// that a program starts a few times for all questions. Nothing is asked later.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/questions.hpp"
#include "experiments/judge/variants.hpp"
#include "reference/truth.hpp"

namespace clipscope::experiments {

// What came of one question about one triangle.
struct Found {
  bool judged = false;
  std::string reason = "";  // empty: it is kept
  double excess = std::numeric_limits<double>::infinity();

  static Found kept() { return {.judged = true}; }
  static Found broken(std::string reason) { return {.judged = true, .reason = std::move(reason)}; }
};

class BitQuestions {
 public:
  // given: the answers to the batch. What is given outlives the object.
  BitQuestions(const Contestant& contestant, const Batch& batch, const Questions& asked,
               const Answers& given);

  // Pre-condition: there is an answer to the triangle as given.
  Found judge(Question question, std::size_t triangle) const;

  // Which variant of the triangle has no answer, and why; empty if all asked have one.
  std::string failure(std::size_t triangle) const;

 private:
  enum class Order { same, reversed, alone };
  struct Asked {
    Question question;
    std::string how;  // it was asked: "with its second vertex first"
    Variant variant;
    Order order = Order::same;
    std::vector<double> constants = {};  // of the last attributes
    // Where its answers are: from this place on among those to a batch that was asked about.
    std::size_t round = 0, first = 0;
  };

  void add_variants(const Questions& asked);
  void add_constants();
  void add_watertight();
  void add_steady();
  void ask();
  bool joins(const Asked& asked) const;
  std::optional<PolygonView> answer(const Asked& asked, std::size_t triangle) const;
  template <class Judge>
  Found judge_variants(Question question, std::size_t triangle, const Judge& judge) const;
  Found judge_total(std::size_t triangle) const;
  Found judge_confined(std::size_t triangle) const;
  Found judge_watertight(std::size_t triangle) const;
  Found judge_steady(std::size_t triangle) const;
  bool first_edge_lies_in_a_plane(std::size_t triangle) const;
  std::optional<std::vector<VertexView>> on_first_edge(const Batch& batch, std::size_t triangle,
                                                       const PolygonView& polygon) const;

  const Contestant& contestant_;
  const Batch& batch_;
  const Answers& given_;
  std::vector<char> has_room_;
  std::map<std::size_t, std::string> misconduct_;  // of a guest, by triangle
  std::size_t lone_ = 0;                           // the triangle that is asked about alone
  std::optional<reference::Truth> truth_;          // where vertices on an edge are found by it
  std::vector<Asked> asked_;
  std::vector<std::optional<Answers>> rounds_;
};

}  // namespace clipscope::experiments
