// SPDX-License-Identifier: GPL-3.0-or-later
//
// What runners of a stage have in common: the form of the answer, and its reading.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {

// Inside triangles by number, counted from the first of the call; polygons one after the other.
struct StageAnswer {
  std::span<const std::uint32_t> inside;
  std::span<const batch::PolygonEnd> polygons;
  std::span<const float> vertices;
};

class StageRunner : public Runner {
 public:
  StageRunner(Contract contract, const StageInput& input) : contract_(contract), input_(input) {}

  void clip(std::size_t batch, std::size_t first, std::size_t count) final;
  Answers answers() const final;
  std::size_t bytes_written() const final;
  std::string malformed() const final;

 protected:
  Contract contract() const { return contract_; }
  const StageInput& input() const { return input_; }

 private:
  // Clips triangles [first, first + count) of the contract's layout.
  virtual void clip_stage(std::size_t first, std::size_t count) = 0;
  virtual StageAnswer answer() const = 0;

  Contract contract_;
  const StageInput& input_;
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace clipscope::experiments
