// SPDX-License-Identifier: GPL-3.0-or-later
//
// A process with a plug-in in it (spaces/plugin/host.cpp): started, asked, and ended.
//
// It is started with posix_spawn, which copies no memory of this process, however much that has.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "experiments/contestants/answers.hpp"
#include "spaces/plugin/channel.hpp"

namespace clipscope::experiments {

// Memory that the program and a host share, as the program sees it. It only grows.
class SharedArea {
 public:
  SharedArea() = default;
  ~SharedArea();
  SharedArea(SharedArea&& other) noexcept { *this = std::move(other); }
  SharedArea& operator=(SharedArea&& other) noexcept;

  // Whether it had to become another one, what was in it lost. Errors: std::bad_alloc.
  bool reserve(std::size_t bytes);
  std::size_t size() const { return bytes_; }
  int file() const { return file_; }
  unsigned char* begin() const { return begin_; }
  unsigned char* end() const { return begin_ + bytes_; }
  // The last so many elements of it.
  template <class T>
  T* last(std::size_t count) const {
    return reinterpret_cast<T*>(end() - count * sizeof(T));
  }

 private:
  int file_ = -1;
  unsigned char* begin_ = nullptr;
  std::size_t bytes_ = 0;
};

// A file that is installed with the program, or stands where it was built. Errors: GuestError.
std::filesystem::path file_of_program(const std::string& name);

class PluginHost {
 public:
  // Starts it and loads the library. Errors: GuestError, which says why the plug-in can't be asked.
  PluginHost(const std::string& library, const std::vector<int>& processors);
  ~PluginHost();
  PluginHost(const PluginHost&) = delete;
  PluginHost& operator=(const PluginHost&) = delete;

  const plugin::Description& description() const { return control().description; }
  plugin::Request& request() { return control().request; }
  // Of the last order that was answered.
  const plugin::Control& control() const {
    return *reinterpret_cast<const plugin::Control*>(shared_.begin());
  }

  // What became of it, if the order was not answered: then the host is gone.
  std::optional<Failure> ask(plugin::Order order, double seconds);
  // The same, whatever was wrong.
  std::optional<Failure> hand_over(plugin::Use use, std::size_t index, const SharedArea& area);

  // Under the clock the host gets the processor that the calling thread keeps to, so that who is
  // timed beside it has the same one; the thread waits on another meanwhile, without sleeping.
  void enter_clock();
  void leave_clock();
  // How often it has lost its processor so far. It is awake then.
  std::int64_t lost_processor();

 private:
  plugin::Control& control() { return *reinterpret_cast<plugin::Control*>(shared_.begin()); }
  void start(const std::string& library);
  void let_run_on(const std::vector<int>& processors);
  void stay_awake(double program_us, double host_us);
  bool wake(int scheduling_class, int priority);
  bool is_answered(double seconds);
  // What the plug-in has printed and nobody has read: to standard error, unless it is the last
  // thing that it did.
  std::string read_printed() const;
  std::string last_printed() const;  // ", printing: a | b"; empty if nothing
  void pass_on_printed() const;
  bool has_ended();
  void end();
  Failure failure_of_end() const;

  std::string library_;
  SharedArea shared_;
  pid_t process_ = -1;
  int socket_ = -1, printed_ = -1, status_ = 0;
  std::vector<int> processors_;
  std::optional<int> measured_ = {};  // the processor, under the clock
  std::uint32_t orders_ = 0;
  double awake_us_ = 0;
};

}  // namespace clipscope::experiments
