// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/verification.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/selection/replay_text.hpp"
#include "experiments/survey/case_batch.hpp"

namespace clipscope::experiments::commands {
namespace {

// "options : hex floats", see replay_text.
constexpr std::string_view kBetween = " : ";

nlohmann::json number_or_inf(double x) {
  return std::isfinite(x) ? nlohmann::json(x) : nlohmann::json("inf");
}

std::vector<std::string_view> names_in(const Questions& questions) {
  std::vector<std::string_view> names;
  for (const Question q : questions.list()) names.push_back(name_of(q));
  return names;
}

// The first counterexample of a question, and the source that it is of.
struct Found {
  const SourceFindings* source = nullptr;
  const Counterexample* counterexample = nullptr;
};
Found first_of(const Verification& verification, Question question) {
  for (const SourceFindings& source : verification.sources) {
    const auto& first = source.found.of(question).first;
    if (first) return {&source, &*first};
  }
  return {};
}

nlohmann::json counterexample_json(const Found& found) {
  if (found.counterexample == nullptr) return nullptr;
  const Counterexample& c = *found.counterexample;
  return {{"case", c.triangle.name},
          {"reason", c.violation.reason},
          {"hex", hex_of(c)},
          {"replay", verify_command(*found.source, c)}};
}

nlohmann::json promise_json(const Verification& verification, const Examination& found,
                            Question question) {
  const QuestionTally& tally = found.of(question);
  nlohmann::json json = {{"name", name_of(question)},
                         {"asked", found.asked().contains(question)},
                         {"judged", tally.judged},
                         {"broken", tally.broken},
                         {"counterexample", counterexample_json(first_of(verification, question))}};
  json["held"] = tally.judged > 0 ? nlohmann::json(tally.is_kept()) : nlohmann::json(nullptr);
  return json;
}

nlohmann::json outcomes_json(const OutcomeCounts& counts) {
  nlohmann::json json = nlohmann::json::object();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] > 0) json[std::string(kOutcomeNames[i])] = counts[i];
  }
  return json;
}

}  // namespace

Examination findings(const Verification& verification) {
  Examination all = verification.sources.front().found;
  for (std::size_t i = 1; i < verification.sources.size(); ++i) {
    all += verification.sources[i].found;
  }
  return all;
}

int exit_code(const Verification& verification) {
  const Examination found = findings(verification);
  if (found.broken > 0) return kExitPromiseBroken;
  if (found.judged == 0) return kExitNothingJudged;
  for (const Question q : found.asked().list()) {
    if (verification.is_named && found.of(q).judged == 0) return kExitNothingJudged;
  }
  return kExitOk;
}

std::string_view question_text(Question question) {
  switch (question) {
    case Question::total: return "an answer to every triangle, its x, y and z finite";
    case Question::confined: return "|x| and |y| at most 1 and z in its range, to the bit";
    case Question::contained: return "nothing drawn outside volume and triangle, within the bound";
    case Question::covers: return "no visible part lost, within the bound";
    case Question::winding: return "the polygon wound as the triangle";
    case Question::watertight: return "a neighbour with the same vertices on the shared edge";
    case Question::rotation: return "the same vertices whichever is first";
    case Question::scale: return "the same vertices for coordinates times 2^8";
    case Question::constants: return "an attribute that is constant stays what it is";
    case Question::faithful: return "every number one of the two next to the exact one";
    case Question::correctly_rounded: return "every number the float nearest to the exact one";
    case Question::steady: return "the same bits again, alone and in another order";
  }
  return "";
}

std::string hex_of(const Counterexample& counterexample) {
  const std::string text = replay_text(CaseBatch(counterexample.triangle), 0);
  return text.substr(text.find(kBetween) + kBetween.size());
}

std::string verify_command(const SourceFindings& source, const Counterexample& counterexample) {
  const Contestant& contestant = source.found.contestant();
  if (!source.by_case) return verify_command(contestant, counterexample);
  return fmt::format("clipscope verify {} --promise {} {} --case {}", options_of(contestant),
                     name_of(counterexample.violation.question), source.options,
                     shell_word(counterexample.triangle.name));
}

std::string verify_command(const Contestant& contestant, const Counterexample& counterexample) {
  const std::string text = replay_text(CaseBatch(counterexample.triangle), 0);
  return fmt::format("echo '{}' | clipscope verify {} --promise {} {} --input -",
                     hex_of(counterexample), options_of(contestant),
                     name_of(counterexample.violation.question),
                     text.substr(0, text.find(kBetween)));
}

nlohmann::json json_of(const Verification& verification) {
  const Examination found = findings(verification);
  const Contestant& contestant = found.contestant();
  nlohmann::json json = {{"clipper", contestant.clipper},
                         {"scalar", contestant.scalar()},
                         {"triangles", found.triangles},
                         {"judged", found.judged},
                         {"not_applicable", found.not_taken},
                         {"outside_domain", found.outside_domain},
                         {"outside_domain_wrong", sum_of(found.wrong_outside)},
                         {"outside_domain_outcomes", outcomes_json(found.wrong_outside)},
                         {"unanswered", found.unanswered},
                         {"broken", found.broken},
                         {"kept", exit_code(verification) == kExitOk},
                         {"holds", names_in(found.kept())}};
  json["shrunk"] = nullptr;
  if (const auto& smallest = verification.smallest) {
    json["shrunk"] = hex_of(*smallest);
    json["shrunk_case"] = case_text(smallest->triangle);
    json["shrunk_replay"] = verify_command(contestant, *smallest);
  }
  json["promises"] = nlohmann::json::array();
  for (const Question q : found.examined().list()) {
    json["promises"].push_back(promise_json(verification, found, q));
  }
  json["largest_backward_error_ulp"] = number_or_inf(found.largest_ulps);
  json["largest_backward_error_case"] =
      found.farthest ? nlohmann::json(found.farthest->name) : nlohmann::json(nullptr);
  json["promised_backward_error_ulp"] =
      contestant.is_guest ? nlohmann::json(nullptr) : number_or_inf(contestant.promise.ulps);
  if (found.worst) {
    json["worst"] = {{"case", found.worst->triangle.name},
                     {"reason", found.worst->violation.reason},
                     {"hex", hex_of(*found.worst)},
                     {"output", found.worst->answer}};
  }
  return json;
}

}  // namespace clipscope::experiments::commands
