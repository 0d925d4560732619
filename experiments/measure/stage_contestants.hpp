// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants of the stage contract: clip-space triangles in, clip-space polygons out, no divide.
//
//   textbook                       the baseline: vectors copied at each plane; copy
//   homogeneous/sutherland_hodgman the scalar clipper without its divide, in float and double; copy
//   homogeneous/batch and so on     spaces/batch, plain and SIMD, in every contract
//
// What comes out is float, rounded once where a method computes in another format.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "experiments/measure/stage_input.hpp"

namespace clipscope::experiments {

// What a contestant promises of its polygons, in clip space.
enum class StagePromise {
  float_chain,       // within kChainUlps of float (spaces/clipper.hpp)
  rounded_once,      // within one rounding to float of the exact answer, but for errors of double
  bits_of_scalar,    // the bits of homogeneous/sutherland_hodgman in float before its divide
  correctly_rounded  // every float the one nearest to the exact value, the vertices exactly right
};

// Inside triangles by number (contracts by reference and indexed), polygons one after the other.
struct StageAnswer {
  std::span<const std::uint32_t> inside;
  std::span<const batch::PolygonEnd> polygons;
  std::span<const float> vertices;
  std::size_t stride = 4;  // floats per vertex

  std::span<const float> polygon(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : polygons[i - 1].end;
    return vertices.subspan(begin * stride, (polygons[i].end - begin) * stride);
  }
  // As numbers of the bytes that were written.
  std::size_t bytes() const {
    return inside.size_bytes() + polygons.size_bytes() + vertices.size_bytes();
  }
};

// One thread at a time: it keeps its answer.
class StageContestant {
 public:
  StageContestant(std::string method, std::string scalar, std::string build, StageContract contract,
                  StagePromise promise)
      : method_(std::move(method)),
        scalar_(std::move(scalar)),
        build_(std::move(build)),
        contract_(contract),
        promise_(promise) {}
  virtual ~StageContestant() = default;

  const std::string& method() const { return method_; }
  const std::string& scalar() const {
    return scalar_;
  }  // of a batch clipper float, what its vertices are in
  const std::string& build() const { return build_; }  // "scalar", "plain" or "simd"
  StageContract contract() const { return contract_; }
  StagePromise promise() const { return promise_; }
  std::string name() const;  // "homogeneous/batch float simd reference"

  // Clips triangles [first, first + count) of the input's layout; the numbers in the answer count from
  // `first`. Pre-condition: the input has the layout.
  virtual void clip(const StageInput& input, std::size_t first, std::size_t count) = 0;
  virtual StageAnswer answer() const = 0;

 private:
  std::string method_, scalar_, build_;
  StageContract contract_;
  StagePromise promise_;
};

using StageContestants = std::vector<std::unique_ptr<StageContestant>>;

// The baseline. Attribute counts that it is compiled for: 0, 1, 2, 4, 8, 16, 32.
std::unique_ptr<StageContestant> stage_textbook();
std::unique_ptr<StageContestant> stage_sutherland_hodgman(std::string_view scalar);
std::unique_ptr<StageContestant> stage_batch(batch::Method method, StageContract contract,
                                             batch::Build build);

// All that take the input: the baseline first.
StageContestants stage_contestants(const StageInput& input);

}  // namespace clipscope::experiments
