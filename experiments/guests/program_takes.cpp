// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a program takes, as a list of words.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "experiments/guests/program.hpp"
#include "experiments/machine/errors.hpp"
#include "spaces/volume.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, 2> kSpaceWords = {"view", "clip"};
constexpr std::array<std::string_view, 3> kDepthWords = {"gl", "zero_to_one", "reversed"};
constexpr std::array<std::string_view, 4> kPrimitiveWords = {"points", "segments", "triangles",
                                                             "polygons"};

template <std::size_t N>
std::optional<std::size_t> place_of(std::string_view word,
                                    const std::array<std::string_view, N>& in) {
  const auto found = std::ranges::find(in, word);
  if (found == in.end()) return std::nullopt;
  return static_cast<std::size_t>(found - in.begin());
}

// "attributes": as many as there can be; "attributes=4". Nothing if the word is none of these.
std::optional<int> attributes_of(std::string_view word) {
  constexpr std::string_view kWord = "attributes";
  if (word == kWord) return kMaxAttributes;
  if (!word.starts_with(kWord) || word[kWord.size()] != '=') return std::nullopt;
  int count = -1;
  const char* const end = word.data() + word.size();
  const auto [last, error] = std::from_chars(word.data() + kWord.size() + 1, end, count);
  const bool is_good = error == std::errc() && last == end && count >= 0 && count <= kMaxAttributes;
  return is_good ? std::optional(count) : std::nullopt;
}

// A list of a program, read word by word.
class TakesReader {
 public:
  explicit TakesReader(ProgramOptions& options) : options_(options) {}

  void read(std::string_view word) {
    if (const auto space = place_of(word, kSpaceWords)) {
      options_.space = static_cast<Space>(*space);
    } else if (const auto depth = place_of(word, kDepthWords)) {
      if (!names_depths_) options_.depths = {};
      names_depths_ = options_.depths[*depth] = true;
    } else if (const auto primitive = place_of(word, kPrimitiveWords)) {
      add(static_cast<Primitive>(*primitive));
    } else if (const auto attributes = attributes_of(word)) {
      options_.most_attributes = std::max(options_.most_attributes, *attributes);
    } else if (word == "clip-distances") {
      options_.clip_distances = true;
      options_.most_attributes = std::max(options_.most_attributes, kMaxClipDistances);
    } else if (word == "depth-clamp") {
      options_.depth_clamp = true;
    } else if (word == "half-open") {
      options_.open_sides = true;
    } else if (word == "hex") {
      options_.hex = true;
    } else {
      throw UsageError(
          fmt::format("--takes: '{}' given; expected some of {}", word, takes_words()));
    }
  }

 private:
  void add(Primitive primitive) {
    if (!names_primitives_) options_.primitives.clear();
    names_primitives_ = true;
    if (std::ranges::find(options_.primitives, primitive) == options_.primitives.end()) {
      options_.primitives.push_back(primitive);
    }
  }

  ProgramOptions& options_;
  bool names_depths_ = false, names_primitives_ = false;
};

}  // namespace

void set_takes(const std::vector<std::string>& list, ProgramOptions& options) {
  TakesReader reader(options);
  for (const std::string& word : list) reader.read(word);
}

std::string takes_list(const ProgramOptions& options) {
  const ProgramOptions usual;
  std::vector<std::string> words;
  if (options.space != usual.space) {
    words.emplace_back(kSpaceWords[static_cast<std::size_t>(options.space)]);
  }
  if (options.depths != usual.depths) {
    for (std::size_t d = 0; d < kDepthWords.size(); ++d) {
      if (options.depths[d]) words.emplace_back(kDepthWords[d]);
    }
  }
  if (options.primitives != usual.primitives) {
    for (const Primitive p : options.primitives) {
      words.emplace_back(kPrimitiveWords[static_cast<std::size_t>(p)]);
    }
  }
  if (options.most_attributes > 0) {
    words.push_back(fmt::format("attributes={}", options.most_attributes));
  }
  if (options.clip_distances) words.emplace_back("clip-distances");
  if (options.depth_clamp) words.emplace_back("depth-clamp");
  if (options.open_sides) words.emplace_back("half-open");
  if (options.hex) words.emplace_back("hex");
  return fmt::format("{}", fmt::join(words, ","));
}

std::string_view takes_words() {
  return "view, clip; gl, zero_to_one, reversed; triangles, segments, points, polygons; attributes, attributes=K; clip-distances, depth-clamp, half-open; hex";
}

}  // namespace clipscope::experiments
