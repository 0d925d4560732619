// SPDX-License-Identifier: GPL-3.0-or-later
//
// The smallest triangle that breaks what `clipscope verify` found broken.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "experiments/commands/verification.hpp"
#include "experiments/shrink/shrink.hpp"
#include "experiments/survey/case_batch.hpp"

namespace clipscope::experiments::commands {
namespace {

// Whether the shrinker takes it: a triangle of floats, against a frustum or in clip space.
bool can_be_shrunk(const HardCase& c) {
  const auto is_float = [](double x) { return double{static_cast<float>(x)} == x; };
  return !c.matrix && std::ranges::all_of(c.vertices, [&](const reference::InputVertex& v) {
    const auto end = v.attributes.begin() + c.attribute_count;
    return std::ranges::all_of(v.position, is_float) &&
           std::all_of(v.attributes.begin(), end, is_float);
  });
}

// As the name of a case: one word.
std::string word_of(std::string text) {
  for (char& c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return text;
}

}  // namespace

std::optional<Counterexample> smallest_of(const Verification& verification) {
  for (const SourceFindings& source : verification.sources) {
    const Counterexample* first = source.found.first_broken();
    if (first == nullptr) continue;
    const Question question = first->violation.question;
    if (question == Question::steady || !can_be_shrunk(first->triangle)) return std::nullopt;
    const Contestant& contestant = source.found.contestant();
    Counterexample smallest = *first;
    smallest.triangle = shrink(contestant, first->triangle, question);
    const auto found = examine(contestant, CaseBatch(smallest.triangle), {question});
    const BrokenPromise* violation = found[0].violation(question);
    if (violation == nullptr) return std::nullopt;  // not when it is asked again
    smallest.violation = *violation;
    smallest.triangle.name = word_of(
        fmt::format("{} {} {}", contestant.clipper, contestant.scalar(), name_of(question)));
    smallest.triangle.source =
        fmt::format("shrunk by clipscope verify from {}", first->triangle.name);
    smallest.triangle.why = violation->reason;
    return smallest;
  }
  return std::nullopt;
}

}  // namespace clipscope::experiments::commands
