// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plug-in with its input: what clips where the contestant is a plug-in.
//
// The input is written once, into memory that its host reads in place. A batch is asked in blocks;
// one that is not answered is halved until the primitives that are to blame are found, each of
// which then has no answer, and a reason. What only a batch brings about is blamed on the primitive
// that ends the shortest batch which does.
#pragma once

#include <memory>
#include <span>

#include "experiments/contestants/contestant.hpp"
#include "experiments/guests/plugin_channel.hpp"

namespace clipscope::experiments {

inline constexpr std::size_t kMostAtOnce = 4096;  // primitives of a block

class PluginRunner : public Runner {
 public:
  // What the questions of conduct.hpp need beside the answers.
  virtual bool is_thread_safe() const = 0;
  virtual void start_anew() = 0;                     // in a host that was never asked
  virtual void fill_output(unsigned char byte) = 0;  // with what the plug-in then finds there
  // Asks in two threads at once; what the second one left. Pre-condition: count <= kMostAtOnce.
  virtual Answers clip_twice(std::size_t batch, std::size_t first, std::size_t count) = 0;
};

// In float or double. The plug-in and the batches outlive it.
std::unique_ptr<PluginRunner> make_plugin_runner(Plugin& plugin, const Format& format,
                                                 std::span<const Batch> batches);

}  // namespace clipscope::experiments
