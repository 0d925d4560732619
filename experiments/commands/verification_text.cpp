// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/verification.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/table/terminal.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr std::size_t kPromiseWidth = 19, kHeldWidth = 16;

std::string spoken(Question question) {
  std::string name(name_of(question));
  std::ranges::replace(name, '_', ' ');
  return name;
}

std::string triangles(std::size_t n) { return counted(n, "triangle", "triangles"); }

// "wrong answers among these: 80 (60 missing, 20 visible)".
std::string wrong_text(const OutcomeCounts& wrong) {
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    if (wrong[i] > 0) parts.push_back(fmt::format("{} {}", wrong[i], kOutcomeNames[i]));
  }
  if (parts.empty()) return "no answer among these is wrong";
  return fmt::format("wrong answers among these: {} ({})", sum_of(wrong), fmt::join(parts, ", "));
}

std::string heading(const Verification& verification, const Examination& found) {
  const Contestant& contestant = found.contestant();
  const std::string name = name_of(contestant);
  const std::string promise = contestant.is_guest || verification.is_named ? "" : "promise ";
  switch (exit_code(verification)) {
    case kExitOk: return fmt::format("{}: {}kept on {}", name, promise, triangles(found.judged));
    case kExitPromiseBroken:
      return fmt::format("{}: {}BROKEN on {}; judged: {}", name, promise, triangles(found.broken),
                         found.judged);
    default: break;
  }
  if (found.judged > 0) return name + ": NOT JUDGED, some promise that was asked for";
  return name + ": NOTHING JUDGED: no triangle was found that the promise speaks of";
}

std::string held_text(const QuestionTally& tally) {
  if (tally.judged == 0) return "not judged";
  return tally.broken == 0 ? "yes" : fmt::format("no, on {}", tally.broken);
}

// A row of the table: promise, held?, first counterexample.
std::string row(std::string_view promise, std::string_view held, const std::string& example) {
  std::string line = fmt::format("  {:<{}}{:<{}}", promise, kPromiseWidth, held, kHeldWidth);
  if (example.empty()) return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  std::string text;
  for (const std::string& part : wrapped(example, kTextWidth - line.size())) {
    text += line + part + "\n";
    line.assign(line.size(), ' ');
  }
  return text;
}

std::string row_of(const Examination& found, Question question) {
  const QuestionTally& tally = found.of(question);
  return row(spoken(question), held_text(tally),
             tally.first ? tally.first->triangle.name + ": " + tally.first->violation.reason : "");
}

// What is asked for, then the rest of what was examined.
std::string table_text(const Examination& found) {
  std::string text = row("promise", "held?", "first counterexample"), rest;
  for (const Question q : found.examined().list()) {
    (found.asked().contains(q) ? text : rest) += row_of(found, q);
  }
  return rest.empty() ? text : text + "not asked for:\n" + rest;
}

// The backward error in units of the promise (spaces/clipper.hpp).
std::string error_text(const Examination& found) {
  const Contestant& contestant = found.contestant();
  if (!found.asked().has_any({Question::contained, Question::covers})) return "";
  const Format& format = *contestant.format;
  if (format.is_exact()) {
    return fmt::format("backward error: {}\n",
                       found.largest_ulps == 0 ? "none, as promised" : "some; none is promised");
  }
  const bool is_stated = std::isfinite(contestant.promise.ulps);
  std::string text =
      fmt::format("largest backward error: {:.3g} u M{}; {:.3g} u M {}\n", found.largest_ulps,
                  found.farthest ? ", on " + found.farthest->name : "",
                  is_stated ? contestant.promise.ulps : kChainUlps,
                  is_stated ? "is promised" : "is the bound, since none is stated");
  text += fmt::format(
      "  u: unit roundoff of {}; M: size of the triangle's clip coordinates{}\n", format.name,
      contestant.promise.amplification == Promise::Amplification::w_ratio ? ", times w_max / w_min"
                                                                          : "");
  return text;
}

// What a guest's author may promise of it, as far as was tried.
std::string strongest_text(const Examination& found) {
  std::vector<std::string> kept;
  for (const Question q : found.kept().list()) kept.push_back(spoken(q));
  if (kept.empty()) return "No promise holds on all that was tried.\n";
  return fmt::format("Holds on all that was tried: {}.\n", fmt::join(kept, ", "));
}

// What was not judged, and what became of it.
std::string unjudged_text(const Examination& found) {
  std::string text;
  if (found.unanswered > 0) text += fmt::format("no answer to: {}\n", triangles(found.unanswered));
  if (found.outside_domain > 0) {
    text += fmt::format("outside the promise's domain: {}; {}\n", triangles(found.outside_domain),
                        wrong_text(found.wrong_outside));
  }
  if (found.not_taken > 0) {
    text += fmt::format("not taken by the clipper: {}\n", triangles(found.not_taken));
  }
  return text;
}

// Each line of a text broken where a terminal ends.
std::string in_lines(const std::string& text) {
  std::string broken;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blanks = std::min(line.find_first_not_of(' '), line.size());
    const std::string indent(blanks, ' ');
    for (const std::string& part : wrapped(line.substr(blanks), kTextWidth - blanks)) {
      broken += indent + part + "\n";
    }
  }
  return broken;
}

// The commands that show again what was asked for and broken, the first and the smallest.
std::string replay_text_of(const Verification& verification) {
  std::string text;
  for (const SourceFindings& source : verification.sources) {
    const Counterexample* first = source.found.first_broken();
    if (first == nullptr) continue;
    text =
        fmt::format("see {} again:\n  {}\n", first->triangle.name, verify_command(source, *first));
    break;
  }
  if (const auto& smallest = verification.smallest) {
    const Contestant& contestant = verification.sources.front().found.contestant();
    text += fmt::format("shrunk, as a case for a corpus:\n{}see it again:\n  {}\n",
                        case_text(smallest->triangle), verify_command(contestant, *smallest));
  }
  return text;
}

}  // namespace

std::string text_of(const Verification& verification) {
  const Examination found = findings(verification);
  std::string text = heading(verification, found) + "\n";
  if (found.triangles > found.not_taken) text += table_text(found);
  std::string notes = found.judged > 0 ? error_text(found) : "";
  if (found.contestant().is_guest) notes += strongest_text(found);
  notes += unjudged_text(found);
  text += in_lines(notes);
  return text + replay_text_of(verification);
}

}  // namespace clipscope::experiments::commands
