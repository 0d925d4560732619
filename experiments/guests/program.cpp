// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "experiments/contestants/contestant.hpp"
#include "experiments/guests/bisect.hpp"
#include "experiments/guests/child.hpp"
#include "experiments/guests/process.hpp"
#include "experiments/guests/program_environment.hpp"
#include "experiments/guests/program_text.hpp"
#include "experiments/guests/texts.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/shell_word.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kPrimitivesPerStart = 4096;
// For each start that failed: enough for five primitives far apart among so many, or for one that
// does not end.
constexpr Retries kProgramRetries{.left = 128, .endless_price = 4};

// A program as one contestant.
struct Program {
  ProgramOptions options;
  ProgramForm form;
};

// How it failed; nothing if it ended as it should.
std::optional<Failure> failure_of(const ProcessResult& result, const ProcessLimits& limits) {
  using End = ProcessResult::End;
  const std::string words = last_errors(result.errors);
  switch (result.end) {
    case End::killed:
      return Failure{
          Failure::Kind::crashed,
          fmt::format("is ended by signal {} ({}){}", result.code, strsignal(result.code), words)};
    case End::timed_out:
      return Failure{Failure::Kind::timed_out,
                     fmt::format("does not end within {:g} s{}", limits.seconds, words)};
    case End::too_much_output:
      return Failure{Failure::Kind::malformed,
                     fmt::format("writes more than {} bytes{}", limits.most_output, words)};
    case End::exited: break;
  }
  if (result.code == 0) return std::nullopt;
  return Failure{Failure::Kind::crashed,
                 fmt::format("ends with exit code {}{}", result.code, words)};
}

class ProgramRunner final : public Runner {
 public:
  ProgramRunner(std::shared_ptr<const Program> program, std::span<const Batch> batches)
      : program_(std::move(program)), answers_(*program_->form.format, 4) {
    for (const Batch& batch : batches) {
      Part& part = parts_.emplace_back(
          Part{guest_input(batch, *program_->form.format, program_->options.space), {}});
      part.environment = program_environment(batch, part.input, program_->form);
    }
  }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    const Part& part = parts_[batch];
    answers_ = Answers(*program_->form.format, 4 + static_cast<std::size_t>(part.input.attributes));
    for (std::size_t done = 0; done < count; done += kPrimitivesPerStart) {
      const Range range{first + done, std::min(kPrimitivesPerStart, count - done)};
      Retries retries = kProgramRetries;
      Bisection([&](const Range& half) { return ask(part, half, range.count); },
                [&](const Range&) { keep(); }, answers_, retries)(range);
    }
  }

  Answers answers() const override { return answers_; }

 private:
  struct Part {
    GuestInput input;
    std::vector<std::string> environment;
  };

  // A start of its own takes some time, however few are asked about.
  double seconds_for(std::size_t count, std::size_t whole) const {
    constexpr double kStart = 2;
    const double all = program_->options.seconds;
    const double share = static_cast<double>(count) / static_cast<double>(whole);
    return std::clamp(all * share, std::min(all, kStart), all);
  }

  ProcessLimits limits_for(const Part& part, std::size_t count, std::size_t whole) const {
    constexpr std::size_t kVertices = 64, kNumber = 32;  // far more than any answer has; bytes
    return {.seconds = seconds_for(count, whole),
            .most_output = 65536 + count * kVertices * (part.input.stride() + 3) * kNumber};
  }

  std::optional<Failure> ask(const Part& part, const Range& range, std::size_t whole) {
    const ProcessLimits limits = limits_for(part, range.count, whole);
    const ProcessResult result =
        run_process(program_->options.command, lines_of(part.input, range, program_->form),
                    part.environment, kProgramVariables, limits);
    if (auto failure = failure_of(result, limits)) return failure;
    WrittenAnswers written =
        read_answers(result.output, range.count, part.input.attributes, program_->form);
    if (!written.wrong.empty()) return Failure{Failure::Kind::malformed, written.wrong};
    last_ = std::move(written.polygons);
    return std::nullopt;
  }

  void keep() {
    for (WrittenPolygon& polygon : last_) add(polygon);
  }

  void add(WrittenPolygon& polygon) {
    if (!polygon.wrong.empty()) {
      return answers_.fail({Failure::Kind::malformed, std::move(polygon.wrong)});
    }
    for (const double x : polygon.numbers) answers_.add(x);
    answers_.end_polygon();
  }

  std::shared_ptr<const Program> program_;
  std::vector<Part> parts_;
  Answers answers_;
  std::vector<WrittenPolygon> last_;  // what was written to the last question
};

// A primitive inside of every volume there is: a part of a triangle.
Batch batch_inside(const ProgramOptions& options, Primitive primitive) {
  static constexpr std::array kView = {-.5, -.5, -2., .5, -.5, -2., 0., .5, -2.};
  static constexpr std::array kClip = {-.5, -.5, .5, 1., .5, -.5, .5, 1., 0., .5, .5, 1.};
  static constexpr std::size_t kEnd = 3;
  const std::size_t vertices = vertices_of(primitive);
  Batch batch{.space = options.space, .vertices = static_cast<int>(vertices)};
  const auto depth = std::ranges::find(options.depths, true) - options.depths.begin();
  batch.volume.depth = batch.frustum.depth = static_cast<DepthRange>(depth);
  const std::span<const double> numbers = options.space == Space::view
                                              ? std::span<const double>(kView)
                                              : std::span<const double>(kClip);
  if (vertices == 0) {
    batch.numbers = numbers;
    batch.ends = std::span(&kEnd, 1);
  } else {
    batch.numbers = numbers.first(numbers.size() / 3 * vertices);
  }
  return batch;
}

// Errors: GuestError if it does not start, or fails on what every program can answer.
void try_out(const Contestant& contestant, const ProgramOptions& options, Primitive primitive) {
  const Answers answers = clip(contestant, batch_inside(options, primitive));
  const Failure* failure = answers[0].failure();
  if (failure == nullptr || failure->kind == Failure::Kind::malformed) return;
  throw GuestError(
      fmt::format("--program '{}': it can't be asked: given one {} inside the volume {}",
                  options.command, to_string(primitive), failure->reason));
}

// What brings it again, under the same name.
std::string option_text(const ProgramOptions& options) {
  std::string text = "--program " + shell_word(options.command);
  const std::string takes = takes_list(options);
  if (!takes.empty()) text += " --takes " + takes;
  if (!options.name.empty()) text += " --name " + shell_word(options.name);
  return text;
}

Contestant contestant_of(const std::shared_ptr<const Program>& program, std::string_view name,
                         std::string_view summary) {
  const ProgramOptions& options = program->options;
  Contestant contestant{.clipper = name,
                        .summary = summary,
                        .source = "a program of the user's",
                        .format = program->form.format,
                        .vertices = static_cast<int>(vertices_of(program->form.primitive)),
                        .promise = no_promise(),
                        .takes_clip_space = options.space == Space::clip,
                        .is_guest = true,
                        .brought_by = kept_text(option_text(options)),
                        .untimed = "a program is judged, not timed",
                        .depths = options.depths,
                        .most_attributes = options.most_attributes};
  contestant.promise.clip_distances = options.clip_distances;
  contestant.promise.depth_clamp = options.depth_clamp;
  contestant.promise.open_sides = options.open_sides;
  contestant.prepare = [program](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<ProgramRunner>(program, batches);
  };
  return contestant;
}

// The words of a command as a shell splits them, where it has nothing but words and quotes.
std::vector<std::string> words_of(const std::string& command) {
  std::vector<std::string> words;
  bool is_within = false;  // a word
  char quote = 0;
  for (const char c : command) {
    const bool is_quote = quote == 0 ? c == '\'' || c == '"' : c == quote;
    const bool is_gap = quote == 0 && (c == ' ' || c == '\t' || c == '\n');
    if (!is_gap && !is_within) words.emplace_back();
    is_within = !is_gap;
    if (is_quote) {
      quote = quote == 0 ? c : '\0';
    } else if (!is_gap) {
      words.back() += c;
    }
  }
  return words;
}

}  // namespace

std::string program_file(const std::string& command) {
  std::error_code ignored;
  for (const std::string& word : words_of(command)) {
    if (std::filesystem::is_regular_file(word, ignored)) return word;
  }
  return "";
}

std::string program_name(const std::string& command) {
  std::string file = program_file(command);
  const std::vector<std::string> words = words_of(command);
  if (file.empty() && !words.empty()) file = words.front();
  return std::filesystem::path(file).stem().string();
}

std::string_view add_program(const ProgramOptions& options) {
  const std::string_view name =
      kept_text(options.name.empty() ? program_name(options.command) : options.name);
  if (name.empty() || program_name(options.command).empty()) {
    throw GuestError(
        fmt::format("--program: '{}' given; expected a command line", options.command));
  }
  const std::string_view summary = kept_text("program: " + options.command);
  bool is_tried = false;
  for (const Format* format : {&kFormat<float>, &kFormat<double>}) {
    for (const Primitive primitive : options.primitives) {
      const auto program = std::make_shared<const Program>(
          Program{options, {.primitive = primitive, .format = format, .hex = options.hex}});
      const Contestant contestant = contestant_of(program, name, summary);
      if (!is_tried) try_out(contestant, options, primitive);
      is_tried = true;
      add_guest(contestant);
    }
  }
  return name;
}

}  // namespace clipscope::experiments
