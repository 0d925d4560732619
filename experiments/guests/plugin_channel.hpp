// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plug-in and the ways to it: each a host of its own with the memory that it shares, for one
// thread at a time. Where a host ends, a fresh one takes its place and the memory.
#pragma once

#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "experiments/guests/plugin_host.hpp"

namespace clipscope::experiments {

inline constexpr double kPluginSeconds = 2;  // for a batch, unless the user gives it more

class PluginChannel {
 public:
  PluginChannel(std::string library, std::vector<int> processors);

  // Memory that holds so many bytes, at its end. What is in it is lost where it has to grow.
  SharedArea& input(std::size_t index, std::size_t bytes);
  SharedArea& input_ends(std::size_t bytes) { return reserved(input_ends_, bytes); }
  SharedArea& output(std::size_t thread, std::size_t bytes);
  SharedArea& output_ends(std::size_t thread, std::size_t bytes);

  // Asks; why there is no answer, if there is none. Errors: GuestError, where no host starts.
  std::optional<Failure> clip(const plugin::Request& request, double seconds, bool twice = false);
  // The next call finds a host that was never asked before.
  void start_anew() { host_.reset(); }

  const plugin::Description& description() { return host().description(); }
  void enter_clock() { host().enter_clock(); }
  void leave_clock() { host().leave_clock(); }
  std::int64_t lost_processor() { return host().lost_processor(); }

 private:
  struct Shared {
    plugin::Use use;
    std::size_t index = 0;
    SharedArea area = {};
    bool is_known = false;  // to the host
  };

  PluginHost& host();
  SharedArea& reserved(Shared& shared, std::size_t bytes);
  std::optional<Failure> hand_over_all();

  std::string library_;
  std::vector<int> processors_;
  std::unique_ptr<PluginHost> host_;
  std::deque<Shared> inputs_;  // which stay where they are
  Shared input_ends_{plugin::Use::input_ends};
  Shared outputs_[2] = {{plugin::Use::output, 0}, {plugin::Use::output, 1}};
  Shared output_ends_[2] = {{plugin::Use::output_ends, 0}, {plugin::Use::output_ends, 1}};
};

// A plug-in whose description was read. Channels that were given back are taken again.
class Plugin {
 public:
  // Starts the first host. Errors: GuestError.
  Plugin(std::string library, double seconds);

  const plugin::Description& description() const { return description_; }
  bool can(std::uint32_t capability) const { return (description_.capabilities & capability) != 0; }
  double seconds() const { return seconds_; }  // that a batch may take

  std::unique_ptr<PluginChannel> take();
  void give_back(std::unique_ptr<PluginChannel> channel);

 private:
  std::string library_;
  double seconds_;
  // Those of the thread that loads the plug-in: one that measures keeps to one of them.
  std::vector<int> processors_;
  plugin::Description description_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PluginChannel>> idle_;
};

}  // namespace clipscope::experiments
