// SPDX-License-Identifier: MIT
//
// clipscope_plugin_host LIBRARY: the process that a plug-in lives in. The program starts it, hands
// it memory through a socket (channel.hpp), and asks. It ends when the program does, or when the
// plug-in does something that no process survives; the program starts another one then.
#include <dlfcn.h>
#include <poll.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <limits>
#include <thread>

#include "spaces/plugin/call.hpp"
#include "spaces/plugin/channel.hpp"
#include "spaces/plugin/faults.hpp"

namespace clipscope::plugin {
namespace {

constexpr double kForEver = 1e9;  // s

// The processors that the program may run on: the thread that asks may keep to one of them, which
// a process that it starts would inherit.
void use_processors(const Control& control) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (std::size_t p = 0; p < 64 * control.processors.size(); ++p) {
    if (control.processors[p / 64] >> (p % 64) & 1) CPU_SET(p, &set);
  }
  sched_setaffinity(0, sizeof set, &set);
}

// Goes with the program, whatever the plug-in does meanwhile.
void end_with_program() {
  std::thread([] {
    pollfd end{.fd = kSocket, .events = 0, .revents = 0};
    while (poll(&end, 1, -1) <= 0) {
    }
    _exit(0);
  }).detach();
}

const clipscope_plugin* refuse(Control& control, const char* reason) {
  copy_text(reason, control.text);
  control.fault = Fault::loads_not;
  return nullptr;
}

template <class... Numbers>
const clipscope_plugin* refuse(Control& control, const char* format, Numbers... numbers) {
  Text text{};
  std::snprintf(text.data(), text.size(), format, numbers...);
  return refuse(control, text.data());
}

// Null where it is none, and why. Its name and capabilities are the program's to judge.
const clipscope_plugin* load(const char* path, Control& control) {
  void* library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return refuse(control, dlerror());
  void* symbol = dlsym(library, "clipscope_plugin_entry");
  if (symbol == nullptr) {
    return refuse(
        control,
        "it exports no clipscope_plugin_entry; expected the function of clipscope_plugin.h, with C linkage");
  }
  const auto entry = reinterpret_cast<decltype(&clipscope_plugin_entry)>(symbol);
  const clipscope_plugin* plugin = entry(CLIPSCOPE_PLUGIN_ABI);
  if (plugin == nullptr) {
    return refuse(control, "it does not speak version %u of the interface, which is this program's",
                  CLIPSCOPE_PLUGIN_ABI);
  }
  if (plugin->abi_version != CLIPSCOPE_PLUGIN_ABI) {
    return refuse(control,
                  "it speaks version %u of the interface; expected version %u, this program's",
                  plugin->abi_version, CLIPSCOPE_PLUGIN_ABI);
  }
  if (plugin->struct_size < sizeof(clipscope_plugin)) {
    return refuse(control, "its struct_size is %u; expected sizeof(clipscope_plugin), %zu",
                  plugin->struct_size, sizeof(clipscope_plugin));
  }
  if (plugin->name == nullptr || plugin->clip == nullptr) {
    return refuse(control, "it has no %s", plugin->name == nullptr ? "name" : "function clip");
  }
  Description& d = control.description;
  copy_text(plugin->name, d.name);
  copy_text(plugin->summary, d.summary);
  copy_text(plugin->source, d.source);
  d.capabilities = plugin->capabilities;
  d.most_attributes = plugin->most_attributes;
  return plugin;
}

class Host {
 public:
  Host(const char* path, Control& control) : path_(path), control_(control) {
    report_faults(control, memory_);
  }

  // Orders have the numbers 1, 2, 3, …
  void serve() {
    for (std::uint32_t order = 1;; ++order) {
      while (!await(control_.asked, order, {control_.awake_us, kForEver})) {
      }
      control_.fault = Fault::none;
      obey();
      pass(control_.answered, order);
    }
  }

 private:
  void obey() {
    switch (control_.order) {
      case Order::load: plugin_ = load(path_, control_); break;
      case Order::wake: wake(); break;
      case Order::take_area: take_area(); break;
      case Order::clip: clip(); break;
      case Order::clip_twice: clip_twice(); break;
    }
  }

  // In the scheduling class of who asks: that thread waits for this one.
  void wake() {
    if (control_.processors != processors_) use_processors(control_);
    processors_ = control_.processors;
    if (sched_getscheduler(0) != control_.scheduling_class) {
      const sched_param parameters{.sched_priority = control_.scheduling_priority};
      sched_setscheduler(0, control_.scheduling_class, &parameters);
    }
    rusage usage{};
    getrusage(RUSAGE_THREAD, &usage);
    control_.lost_processor = usage.ru_nivcsw;
  }

  void take_area() {
    AreaMessage message;
    int file = -1;
    if (!receive_area(kSocket, message, file)) _exit(0);  // the program is gone
    area(message) = Guarded(file, message.bytes, is_output(message.use));
    close(file);
    if (area(message).begin() == nullptr) refuse(control_, "there is no memory for its data");
  }

  static bool is_output(Use use) { return use == Use::output || use == Use::output_ends; }

  Guarded& area(const AreaMessage& message) {
    if (message.use == Use::input_ends) return memory_.input_ends;
    if (message.use == Use::output) return memory_.outputs[message.index].numbers;
    if (message.use == Use::output_ends) return memory_.outputs[message.index].ends;
    if (memory_.inputs.size() <= message.index) memory_.inputs.resize(message.index + 1);
    return memory_.inputs[message.index];
  }

  void clip() { tell(call(*plugin_, control_.request, memory_, memory_.outputs[0])); }

  void clip_twice() {
    std::atomic<int> ready = 0;
    std::array<Result, 2> results;
    const auto clip_at_once = [&](std::size_t thread) {
      ++ready;
      while (ready < 2) {
      }
      results[thread] = call(*plugin_, control_.request, memory_, memory_.outputs[thread]);
    };
    std::thread second([&] {
      use_fault_stack(1);
      clip_at_once(1);
    });
    clip_at_once(0);
    second.join();
    tell(results[results[0].fault == Fault::none ? 1 : 0]);
  }

  void tell(const Result& result) {
    control_.fault = result.fault;
    control_.code = result.code;
    control_.at = result.at;
    control_.vertices = result.vertices;
  }

  const char* path_;
  Control& control_;
  const clipscope_plugin* plugin_ = nullptr;
  decltype(Control::processors) processors_ = {};
  Memory memory_;
};

int run(const char* path) {
  AreaMessage message;
  int file = -1;
  if (!receive_area(kSocket, message, file)) return 2;
  // Static, since signals may come while the process ends.
  static const Guarded shared(file, message.bytes, true);
  if (shared.begin() == nullptr) return 2;
  auto& control = *reinterpret_cast<Control*>(shared.begin());
  use_processors(control);
  end_with_program();
  static Host host(path, control);
  host.serve();
  return 0;
}

}  // namespace
}  // namespace clipscope::plugin

int main(int argc, char* argv[]) {
  if (argc != 2) {
    std::fputs("clipscope_plugin_host: started by clipscope --plugin, not by hand\n", stderr);
    return 2;
  }
  return clipscope::plugin::run(argv[1]);
}
