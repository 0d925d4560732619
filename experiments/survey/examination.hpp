// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which promises does a contestant keep? What it was asked (judge/questions.hpp) about very many
// triangles, and what came of it: how often each question was judged and how often it broke, with
// the first triangle that broke it, and the backward error.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/contestants/contestant.hpp"
#include "experiments/judge/outcome.hpp"
#include "experiments/judge/questions.hpp"

namespace clipscope::experiments {

// A triangle that breaks something, with all that is needed to see it again.
struct Counterexample {
  HardCase triangle;  // its name says where it comes from
  BrokenPromise violation;
  std::string answer;  // a line per vertex, as hex floats: x y z 1/w, attributes
};

struct QuestionTally {
  std::size_t judged = 0, broken = 0;
  std::optional<Counterexample> first = {};

  bool is_kept() const { return judged > 0 && broken == 0; }
  QuestionTally& operator+=(const QuestionTally& next);  // of triangles that come after
};

class Examination {
 public:
  // examined: what the contestant is asked; asked: what of it the user wants to be kept.
  Examination(const Contestant& contestant, const Questions& examined, const Questions& asked)
      : contestant_(&contestant), examined_(examined), asked_(asked) {}

  // name_of(i): what triangle i of the batch is called. Pre-condition: all numbers are finite.
  void add(const Batch& batch, const std::function<std::string(std::size_t)>& name_of);
  // So many triangles that the contestant does not take.
  void add_untaken(std::size_t count);
  // Of triangles that come after. Pre-condition: the same contestant and questions.
  Examination& operator+=(const Examination& next);

  const Contestant& contestant() const { return *contestant_; }
  const Questions& examined() const { return examined_; }
  const Questions& asked() const { return asked_; }
  const QuestionTally& of(Question question) const {
    return tallies_[static_cast<std::size_t>(question)];
  }

  std::size_t triangles = 0;       // all
  std::size_t not_taken = 0;       // the contestant does not take such
  std::size_t outside_domain = 0;  // the bounds don't speak of them, see Examined
  OutcomeCounts wrong_outside{};   // answers among these that are wrong to see (is_failure)
  std::size_t unanswered = 0;      // see Failure
  std::size_t judged = 0;          // in what is asked, and in the bounds' domain
  std::size_t broken = 0;          // of these, some promise that was asked for

  double largest_ulps = 0;                   // backward error, see PromiseCheck
  std::optional<HardCase> farthest = {};     // the triangle with that
  std::optional<Counterexample> worst = {};  // breaks what was asked; the largest error of these

  // What was examined and kept on all triangles, or broken on some.
  Questions kept() const;
  // The first counterexample of a promise that was asked for, in the order of the questions; total
  // is asked for wherever there is no answer. Null if there is none.
  const Counterexample* first_broken() const;

 private:
  using Name = std::function<std::string()>;
  void add_one(const Batch& batch, std::size_t i, const Name& name, const PolygonView& given,
               const Examined& found);
  void add_outside(const Batch& batch, const Answers& given, const std::vector<Examined>& found);

  const Contestant* contestant_;
  Questions examined_, asked_;
  std::array<QuestionTally, kQuestions> tallies_ = {};
  double worst_ulps_ = 0;
};

}  // namespace clipscope::experiments
