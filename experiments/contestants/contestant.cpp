// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/contestant.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/contestants/fewer_attributes.hpp"
#include "experiments/contestants/made.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {

namespace {

// Whether a batch is segments of the plane: between (x, y, 0, 1), with nothing but the window.
bool is_plane(const Batch& batch) {
  if (batch.space != Space::clip || batch.vertices != 2 || batch.matrix || !batch.planes.empty()) {
    return false;
  }
  const std::size_t stride = batch.stride();
  for (std::size_t vertex = 0; vertex < 2 * batch.size(); ++vertex) {
    if (batch.number(vertex * stride + 2) != 0 || batch.number(vertex * stride + 3) != 1) {
      return false;
    }
  }
  return batch.attributes == 0 && batch.volume.clip_distances == 0;
}

constexpr std::size_t kGuests = 256;

// Its capacity never changes, so that pointers to contestants stay good.
std::vector<Contestant>& all_with_room() {
  static std::vector<Contestant> all = [] {
    std::vector<Contestant> list;
    const auto add = [&](const std::vector<Contestant>& made) {
      list.insert(list.end(), made.begin(), made.end());
    };
    for_each_type(AllScalars{}, [&]<class T>() { add(made_in<T>()); });
    for (const auto& made :
         {made_of_cuts(), made_in_plane(), made_in_batches(), made_for_stages()}) {
      add(made);
    }
    list.reserve(list.size() + kGuests);
    return list;
  }();
  return all;
}

}  // namespace

bool Contestant::takes(const Batch& batch) const {
  if (contract == Contract::plane) return is_plane(batch);
  ClipVolume volume = batch.volume;
  volume.clip_distances += static_cast<int>(batch.planes.size());
  const bool from_view = batch.space == Space::view && !batch.matrix;
  if (from_view && takes_frustum && !takes_frustum(batch.frustum)) return false;
  return vertices == batch.vertices && (from_view || takes_clip_space) &&
         depths[static_cast<std::size_t>(volume.depth)] &&
         volume.clip_distances <= most_attributes && is_applicable(promise, volume);
}

std::span<const Contestant> all_contestants() { return all_with_room(); }

void add_guest(const Contestant& guest) {
  std::vector<Contestant>& all = all_with_room();
  const auto is_same = [&](const Contestant& c) {
    return c.clipper == guest.clipper &&
           (!c.is_guest || (c.format == guest.format && c.vertices == guest.vertices));
  };
  if (std::ranges::any_of(all, is_same)) {
    throw GuestError(
        fmt::format("there is a clipper called {} already; expected another name", guest.clipper));
  }
  if (all.size() == all.capacity()) throw GuestError("there is no room for so many guests");
  all.push_back(guest);
  if (guest.most_attributes < kMaxAttributes) {
    all.back().prepare = with_fewer_attributes(guest.prepare, guest.most_attributes);
  }
}

Answers clip(const Contestant& contestant, const Batch& batch) {
  if (batch.matrix && !contestant.takes_clip_space) {
    throw UsageError(fmt::format(
        "--clipper: {} starts from a frustum, so a --matrix is not applicable; expected one that starts in clip space, such as homogeneous/sutherland_hodgman",
        contestant.clipper));
  }
  const std::unique_ptr<Runner> runner = contestant.prepare(std::span(&batch, 1));
  runner->clip(0, 0, batch.size());
  return runner->answers();
}

std::string options_of(const Contestant& c) {
  if (c.is_guest) return fmt::format("{} --scalar {}", c.brought_by, c.scalar());
  return fmt::format("--clipper {} --scalar {}", c.clipper, c.scalar());
}

std::string name_of(const Contestant& c) {
  if (c.prepare) return fmt::format("{} {}", c.clipper, c.scalar());
  return fmt::format("{} {} {} {}", c.clipper, c.scalar(), c.build, name_of(c.contract));
}

}  // namespace clipscope::experiments
