// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants: every clipper in every scalar, under every contract, as one thing.
//
// A contestant prepares its input once: numbers are rounded to its scalar, matrices computed. What
// runs then was compiled for one clipper, one scalar and one number of attributes; only the call of
// a block is indirect, so that timing sees the clipper alone. Answers come out erased
// (answers.hpp).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "experiments/contestants/answers.hpp"
#include "experiments/contestants/batch.hpp"
#include "experiments/contestants/contract.hpp"
#include "experiments/contestants/stage_input.hpp"
#include "spaces/clipper.hpp"

namespace clipscope::experiments {

// A contestant with its input. For one thread at a time: it keeps its answers.
class Runner {
 public:
  virtual ~Runner() = default;
  // Clips primitives [first, first + count) of a batch; what the last call left is gone.
  virtual void clip(std::size_t batch, std::size_t first, std::size_t count) = 0;
  // What the last call left: a polygon for each primitive. In the stage an inside triangle that is
  // listed by its number is its polygon.
  virtual Answers answers() const = 0;
  // The numbers listed and the polygons written, in a stage: bytes of the last call's answer.
  virtual std::size_t bytes_written() const { return 0; }
  // In a stage, what is wrong with the form of the answer: numbers that do not ascend, say. Else
  // empty.
  virtual std::string malformed() const { return ""; }
  // How often another process that clips in place of the calling thread has lost its processor so
  // far. Asked before and after each run under the clock, so that such a process is awake then.
  virtual std::int64_t interruptions() { return 0; }
  // Around each run under the clock.
  virtual void enter_clock() {}
  virtual void leave_clock() {}
  // Who does the work, where this one hands it on.
  virtual Runner& worker() { return *this; }
};

// What a contestant promises of its polygons in a stage, in clip space.
enum class StagePromise : std::uint8_t {
  float_chain,       // within kChainUlps of float (spaces/clipper.hpp)
  rounded_once,      // within one rounding to float of the exact answer, but for errors of double
  bits_of_scalar,    // the bits of homogeneous/sutherland_hodgman in float before its divide
  correctly_rounded  // every float the one nearest to the exact value, the vertices exactly right
};

// What a guest promises: nothing at all.
constexpr Promise no_promise() {
  Promise promise;
  promise.covers = promise.contained = promise.attributes = promise.total = false;
  promise.rotation_invariant = promise.scale_invariant = promise.constants = false;
  promise.ulps = std::numeric_limits<double>::infinity();
  return promise;
}

struct Contestant {
  std::string_view clipper = {}, summary = {}, source = {};
  const Format* format = nullptr;     // what it computes in; a stage answers in float
  std::string_view build = "scalar";  // a batch clipper's "plain" or "simd"
  Contract contract = Contract::full;
  int vertices = 3;  // of the primitives that it takes; 0: polygons
  Promise promise = {};
  StagePromise stage_promise = StagePromise::float_chain;
  bool takes_clip_space = false;
  // A guest is a clipper that is not ours: it states no promise, and may take less than ours do.
  bool is_guest = false;
  std::string_view brought_by = {};                 // of a guest the option: "--plugin ./mine.so"
  std::string_view untimed = {};                    // why it is not timed; empty: it is
  std::array<bool, 3> depths = {true, true, true};  // by DepthRange
  // Of the attributes of a batch, clip distances and planes in front, a guest is given the first so
  // many, and answers these.
  int most_attributes = kMaxAttributes;
  std::function<bool(const Frustum<double>&)> takes_frustum = {};  // of view space; null: any

  // Contracts full and cut alone. Pre-condition: the contestant takes the batches, which outlive
  // the runner.
  std::function<std::unique_ptr<Runner>(std::span<const Batch>)> prepare = {};
  // Stages alone. Pre-condition: the input has the contract's layout, and outlives the runner.
  std::function<std::unique_ptr<Runner>(const StageInput&)> prepare_stage = {};

  std::string_view scalar() const { return format->name; }
  // Whether it can be asked to clip the batch: its space, its kind of primitive, the volume's
  // options.
  bool takes(const Batch& batch) const;
};

using Contestants = std::vector<const Contestant*>;

// All there are: by scalar, primitive and contract, clippers in the order of spaces/clippers.hpp;
// then the guests.
std::span<const Contestant> all_contestants();

// Adds a guest, whose texts live as long as the program does. Contestants that there are stay where
// they are. Errors: GuestError if there is a clipper of that name, or no room for more.
void add_guest(const Contestant& guest);

// The answers to all primitives of a batch that is taken. UsageError: its matrix is not.
Answers clip(const Contestant& contestant, const Batch& batch);

// What names it on the command line: "--clipper homogeneous/sutherland_hodgman --scalar float", the
// option that brought it in place of a guest's clipper.
std::string options_of(const Contestant& contestant);

// "homogeneous/sutherland_hodgman float", in a stage with build and contract.
std::string name_of(const Contestant& contestant);

}  // namespace clipscope::experiments
