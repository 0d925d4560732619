// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/seeded.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "experiments/guests/texts.hpp"
#include "reference/mutants.hpp"

namespace clipscope::experiments {
namespace {

using reference::BugInfo;
using reference::InputVertex;
using reference::RationalVertex;

// The user's planes as clip distances in front of the attributes, each rounded once to double.
void add_distances(const Batch& batch, std::vector<InputVertex>& vertices) {
  const std::size_t planes = batch.planes.size();
  if (planes == 0) return;
  for (InputVertex& v : vertices) {
    std::shift_right(v.attributes.begin(), v.attributes.end(), static_cast<std::ptrdiff_t>(planes));
    for (std::size_t p = 0; p < planes; ++p) {
      Exact distance(0);
      for (std::size_t c = 0; c < 4; ++c) {
        distance += Exact(batch.planes[p][c]) * Exact(v.position[c]);
      }
      v.attributes[p] = nearest_double(distance);
    }
  }
}

class SeededRunner final : public Runner {
 public:
  SeededRunner(reference::Bug bug, const Format& format, std::span<const Batch> batches)
      : bug_(bug), batches_(batches), answers_(format, 1) {}

  void clip(std::size_t b, std::size_t first, std::size_t count) override {
    Batch batch = batches_[b];
    const int attributes = batch.attributes + static_cast<int>(batch.planes.size());
    answers_ = Answers(answers_.format(), 4 + static_cast<std::size_t>(attributes));
    batch.planes.clear();
    batch.volume.clip_distances += static_cast<int>(batches_[b].planes.size());
    const reference::Truth truth = reference::truth_of(batch);
    for (std::size_t i = first; i < first + count; ++i) {
      std::vector<InputVertex> vertices = input_vertices(batches_[b], i);
      if (reference::is_finite(vertices, batch.attributes)) {
        add_distances(batches_[b], vertices);
        for (const RationalVertex& v :
             reference::textbook_polygon(bug_, truth, vertices, attributes)) {
          add(v);
        }
      }
      answers_.end_polygon();
    }
  }
  Answers answers() const override { return answers_; }

 private:
  void add(const RationalVertex& v) {
    for (const Exact* x : {&v.x, &v.y, &v.z, &v.inv_w}) add(*x);
    for (const Exact& x : v.attributes) add(x);
  }
  void add(const Exact& x) {
    if (answers_.format().is_exact()) return answers_.add(x);
    if (answers_.format().is_float()) return answers_.add(reference::round_to<float>(x));
    answers_.add(reference::round_to<double>(x));
  }

  reference::Bug bug_;
  std::span<const Batch> batches_;
  Answers answers_;
};

constexpr std::string_view kFolder = "seeded/";

const Format* format_named(std::string_view scalar) {
  for (const Format* f : {&kFormat<float>, &kFormat<double>, &kFormat<Exact>}) {
    if (f->name == scalar) return f;
  }
  return nullptr;
}

Contestant seeded(const BugInfo& info, const Format& format) {
  Contestant c;
  c.clipper = kept_text(fmt::format("{}{}", kFolder, info.name));
  c.summary = info.summary;
  c.source = "reference/mutants.hpp";
  c.format = &format;
  c.promise = no_promise();
  c.takes_clip_space = true;
  c.is_guest = true;
  c.brought_by = kept_text(fmt::format("--clipper {}", c.clipper));
  c.prepare = [bug = info.bug, &format](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<SeededRunner>(bug, format, batches);
  };
  return c;
}

}  // namespace

std::vector<std::string_view> seeded_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> all;
    for (const BugInfo& info : reference::all_bugs()) {
      all.push_back(kept_text(fmt::format("{}{}", kFolder, info.name)));
    }
    return all;
  }();
  return names;
}

void add_if_seeded(std::string_view clipper, std::string_view scalar) {
  const Format* const format = format_named(scalar);
  if (format == nullptr || !clipper.starts_with(kFolder)) return;
  const auto is_there = [&](const Contestant& c) {
    return c.clipper == clipper && c.format == format;
  };
  if (std::ranges::any_of(all_contestants(), is_there)) return;
  for (const BugInfo& info : reference::all_bugs()) {
    if (info.name == clipper.substr(kFolder.size())) add_guest(seeded(info, *format));
  }
}

}  // namespace clipscope::experiments
