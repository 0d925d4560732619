// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/contestant.hpp"

#include <fmt/format.h>

#include "experiments/contestants/made.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

bool Contestant::takes(const Batch& batch) const {
  ClipVolume volume = batch.volume;
  volume.clip_distances += static_cast<int>(batch.planes.size());
  return vertices == batch.vertices && (batch.space == Space::view || takes_clip_space) &&
         is_applicable(promise, volume);
}

std::span<const Contestant> all_contestants() {
  static const std::vector<Contestant> all = [] {
    std::vector<Contestant> list;
    const auto add = [&](const std::vector<Contestant>& made) {
      list.insert(list.end(), made.begin(), made.end());
    };
    for_each_type(AllScalars{}, [&]<class T>() { add(made_in<T>()); });
    for (const auto& made : {made_of_cuts(), made_in_batches(), made_for_stages()}) add(made);
    return list;
  }();
  return all;
}

Answers clip(const Contestant& contestant, const Batch& batch) {
  const std::unique_ptr<Runner> runner = contestant.prepare(std::span(&batch, 1));
  runner->clip(0, 0, batch.size());
  return runner->answers();
}

std::string name_of(const Contestant& c) {
  if (c.prepare) return fmt::format("{} {}", c.clipper, c.scalar());
  return fmt::format("{} {} {} {}", c.clipper, c.scalar(), c.build, name_of(c.contract));
}

}  // namespace clipscope::experiments
