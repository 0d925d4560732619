// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/hunt_result.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "experiments/commands/options.hpp"
#include "experiments/machine/progress.hpp"
#include "experiments/machine/shell_word.hpp"

namespace clipscope::experiments::commands {
namespace {

using hunt::Hunted;

// The options that say where to hunt.
std::string ways_of(const hunt::HuntOptions& options) {
  std::string text = options.catalogue ? "" : " --without-catalogue";
  if (options.plain) text += " --plain";
  if (options.in_domain) text += " --in-domain";
  if (options.space) text += *options.space == Space::view ? " --space view" : " --space clip";
  return text;
}

// The one that finds the same again.
std::string hunt_command(const Contestant& contestant, const hunt::HuntOptions& options,
                         const Hunted& hunted) {
  return fmt::format("clipscope hunt {} --measure {} --seed {} --evaluations {}{}",
                     options_of(contestant), name_of(options.measure), options.seed,
                     hunted.evaluations, ways_of(options));
}

// Tells on standard error how far a hunt is, and now and then of a new worst.
class Teller {
 public:
  Teller(const Contestant& contestant, const hunt::HuntOptions& options)
      : options_(options),
        label_(fmt::format("hunt {} {}", name_of(options.measure), name_of(contestant))),
        progress_(label_, kSteps) {}

  void operator()(const Hunted& hunted) {
    const double part = options_.evaluations ? static_cast<double>(hunted.evaluations) /
                                                   static_cast<double>(*options_.evaluations)
                                             : hunted.seconds / options_.seconds;
    const auto steps = static_cast<std::size_t>(std::min(part, 1.0) * kSteps);
    progress_.advance(steps - steps_);
    steps_ = steps;
    if (!hunted.worst || hunted.worst->value <= told_ || hunted.seconds < next_) return;
    told_ = hunted.worst->value;
    next_ = hunted.seconds + kSeconds;
    clear_progress_line();
    fmt::print(stderr, "{}: {:.6g} after {} evaluations\n", label_, told_, hunted.evaluations);
  }

 private:
  static constexpr std::size_t kSteps = 1000;
  static constexpr double kSeconds = 2;  // between two tidings

  const hunt::HuntOptions& options_;
  std::string label_;
  Progress progress_;
  std::size_t steps_ = 0;
  double told_ = 0, next_ = 0;
};

}  // namespace

std::string HuntResult::failing() const {
  std::vector<std::string_view> outcomes;
  for (std::size_t i = 0; i < kOutcomes; ++i) {
    if (hunted.failing[i]) outcomes.push_back(kOutcomeNames[i]);
  }
  return fmt::format("{}", fmt::join(outcomes, ", "));
}

HuntResult hunted_one(const Contestant& contestant, hunt::Measure measure,
                      hunt::HuntOptions options) {
  options.measure = measure;
  HuntResult result{&contestant, measure, {}, {}, {}, {}};
  {
    Teller teller(contestant, options);
    result.hunted = hunt::hunt(contestant, options, [&](const Hunted& h) { teller(h); });
  }
  result.command = hunt_command(contestant, options, result.hunted);
  if (!result.hunted.worst) return result;
  result.worst = described(contestant, measure, *result.hunted.worst, result.command);
  result.shrunk =
      described(contestant, measure, shrunk(contestant, measure, *result.worst, options.in_domain),
                "shrunk from what was found by " + result.command);
  return result;
}

hunt::HuntRow row_of(const HuntResult& r) {
  return {.clipper = std::string(r.contestant->clipper),
          .scalar = std::string(r.contestant->scalar()),
          .measure = std::string(name_of(r.measure)),
          .worst = r.worst ? r.worst->value : 0,
          .evaluations = static_cast<std::int64_t>(r.hunted.evaluations),
          .evaluations_per_second = r.per_second(),
          .failing = r.failing(),
          .replay = r.replay(r.worst),
          .shrunk = r.shrunk ? r.shrunk->value : 0,
          .shrunk_replay = r.replay(r.shrunk),
          .worst_case = r.worst ? cases_text(*r.worst) : "",
          .shrunk_case = r.shrunk ? cases_text(*r.shrunk) : "",
          .hunt = r.command};
}

std::string whole_command(const HuntCommandOptions& options) {
  const Selection& selection = options.selection;
  std::string command = "clipscope hunt";
  if (!selection.clipper.empty()) command += " --clipper " + shell_word(selection.clipper);
  command += command_options(options.guests);
  command += fmt::format(" --scalar {} --measure {} --seed {}", fmt::join(selection.scalars, ","),
                         fmt::join(options.measures, ","), selection.seed);
  command += options.hunt.evaluations ? fmt::format(" --evaluations {}", *options.hunt.evaluations)
                                      : fmt::format(" --seconds {:g}", options.hunt.seconds);
  if (options.hunts > 1) command += fmt::format(" --hunts {}", options.hunts);
  return command + ways_of(options.hunt);
}

}  // namespace clipscope::experiments::commands
