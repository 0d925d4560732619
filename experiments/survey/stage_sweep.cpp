// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/survey/stage_sweep.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <numeric>

#include "experiments/machine/errors.hpp"
#include "experiments/survey/batch_accuracy.hpp"
#include "experiments/survey/lattice_sweep.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kStageChunk = 2048;  // triangles

// The triangles in all three layouts.
StageInput stage_input(const SweepChunk& chunk) {
  std::vector<float> vertices;
  for (const auto& triangle : chunk.clip) {
    for (const auto& v : triangle) {
      for (int c = 0; c < 4; ++c) vertices.push_back(v.position[c]);
      for (int k = 0; k < kSceneAttributes; ++k) vertices.push_back(v.attributes[k]);
    }
  }
  StageInput input = soup_input("sweep", chunk.volume, kSceneAttributes, std::move(vertices));
  input.mesh_vertices = input.vertices;
  input.indices.resize(3 * chunk.clip.size());
  std::iota(input.indices.begin(), input.indices.end(), 0u);
  return input;
}

std::vector<StageSweepRow> sweep_one_stage(const SweepChunk& chunk, std::size_t number,
                                           const Contestants& contestants) {
  const StageInput input = stage_input(chunk);
  Progress silent("", 1);
  const std::vector<BatchAccuracy> results = judge_stage(input, contestants, silent);
  std::vector<StageSweepRow> rows = empty_stage_rows(contestants);
  for (std::size_t c = 0; c < rows.size(); ++c) {
    StageSweepRow& row = rows[c];
    const BatchAccuracy& result = results[c];
    row.triangles = result.triangles;
    row.visible = result.visible;
    row.wrong = result.wrong;
    row.coordinates = result.coordinates;
    row.misrounded = result.coordinates - result.correctly_rounded;
    row.max_px = result.error_px.max();
    if (row.max_px == 0) continue;
    row.worst_chunk = static_cast<std::int64_t>(number);
    row.worst = replay_text(chunk, result.worst_triangle);
  }
  return rows;
}

}  // namespace

StageSweepRow& StageSweepRow::operator+=(const StageSweepRow& other) {
  triangles += other.triangles;
  visible += other.visible;
  wrong += other.wrong;
  coordinates += other.coordinates;
  misrounded += other.misrounded;
  if (other.max_px > max_px || (other.max_px == max_px && other.worst_chunk < worst_chunk)) {
    max_px = other.max_px;
    worst_chunk = other.worst_chunk;
    worst = other.worst;
  }
  return *this;
}

Contestants stage_sweep_contestants(const std::string& clipper_pattern) {
  Contestants chosen;
  for (const Contestant& c : all_contestants()) {
    if (c.prepare_stage &&
        fnmatch(clipper_pattern.c_str(), std::string(c.clipper).c_str(), 0) == 0) {
      chosen.push_back(&c);
    }
  }
  if (!chosen.empty()) return chosen;
  throw UsageError(fmt::format("--clipper: no clipper of a stage matches '{}'", clipper_pattern));
}

std::size_t stage_sweep_chunks(std::uint64_t triangles) {
  return static_cast<std::size_t>((triangles + kStageChunk - 1) / kStageChunk);
}

TableOf<StageSweepRow> stage_sweep_table(std::uint64_t triangles, std::uint64_t seed) {
  return {std::string(StageSweepRow::kName),
          fmt::format("{} random triangles in clip space, seed {}, by the stages of a renderer",
                      triangles, seed)};
}

std::vector<StageSweepRow> empty_stage_rows(const Contestants& contestants) {
  std::vector<StageSweepRow> rows;
  for (const Contestant* c : contestants) {
    StageSweepRow& row = rows.emplace_back();
    row.clipper = c->clipper;
    row.build = c->build;
    row.contract = names_of(Contract{})[static_cast<std::size_t>(c->contract)];
  }
  return rows;
}

void sweep_stage(std::uint64_t triangles, std::uint64_t seed, ChunkNumbers chunks,
                 const Contestants& contestants, Progress& progress,
                 std::vector<StageSweepRow>& rows) {
  const auto work = [&](std::size_t i) {
    const std::uint64_t left = triangles - chunks[i] * kStageChunk;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(kStageChunk, left));
    // Random chunks of odd numbers are in clip space.
    return sweep_one_stage(random_chunk(seed, 2 * chunks[i] + 1, count), chunks[i], contestants);
  };
  work_in_order(chunks.size(), kChunksAtOnce, progress, work,
                [&](const std::vector<StageSweepRow>& part) {
                  for (std::size_t c = 0; c < rows.size(); ++c) rows[c] += part[c];
                });
}

}  // namespace clipscope::experiments
