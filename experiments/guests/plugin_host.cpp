// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin_host.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>
#include <thread>
#include <utility>

#include "experiments/guests/child.hpp"
#include "experiments/guests/plugin_said.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/measuring.hpp"
#include "spaces/plugin/guarded.hpp"

extern char** environ;

namespace clipscope::experiments {
namespace {

constexpr double kLoadingSeconds = 10, kEndingSeconds = 1;
constexpr double kSlice = 0.02;  // s; how late the end of a host is seen, where it says nothing
// Awake between calls that come one after the other; under the clock as long as a call may take.
constexpr double kAwakeUs = 10, kHostAwakeUs = 60, kTimedAwakeUs = 5000;

std::string error_text(int error) { return std::strerror(error); }

// Lets it print to the pipe, and read nothing.
class FileActions {
 public:
  FileActions(int socket, int pipe) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, pipe, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, pipe, STDERR_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, socket, plugin::kSocket);
  }
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

}  // namespace

SharedArea::~SharedArea() {
  if (begin_ != nullptr) munmap(begin_, bytes_);
  if (file_ >= 0) close(file_);
}

SharedArea& SharedArea::operator=(SharedArea&& other) noexcept {
  std::swap(file_, other.file_);
  std::swap(begin_, other.begin_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

bool SharedArea::reserve(std::size_t bytes) {
  if (bytes <= bytes_) return false;
  SharedArea area;
  area.bytes_ = plugin::whole_pages(std::max(bytes, bytes_ + bytes_ / 2));
  area.file_ = plugin::memory_file(area.bytes_);
  if (area.file_ < 0) throw std::bad_alloc();
  void* begin = mmap(nullptr, area.bytes_, PROT_READ | PROT_WRITE, MAP_SHARED, area.file_, 0);
  if (begin == MAP_FAILED) throw std::bad_alloc();
  area.begin_ = static_cast<unsigned char*>(begin);
  *this = std::move(area);
  return true;
}

std::filesystem::path file_of_program(const std::string& name) {
  std::filesystem::path file = file_beside_program(name);
  if (!file.empty()) return file;
  throw GuestError(fmt::format(
      "{} is missing, without which no plug-in can be asked; expected it beside the program, in {}",
      name, folder_of_program().string()));
}

PluginHost::PluginHost(const std::string& library, const std::vector<int>& processors)
    : library_(library), processors_(processors) {
  shared_.reserve(sizeof(plugin::Control));
  new (shared_.begin()) plugin::Control;
  let_run_on(processors_);
  stay_awake(kAwakeUs, kAwakeUs);
  start(library);
  std::optional<Failure> failure;
  if (!plugin::send_area(socket_, {plugin::Use::control, 0, shared_.size()}, shared_.file())) {
    end();
    failure = failure_of_end();
  } else {
    failure = ask(plugin::Order::load, kLoadingSeconds);
  }
  if (failure) {
    throw GuestError(fmt::format("{}: while it is loaded, it {}", library, failure->reason));
  }
  if (control().fault == plugin::Fault::loads_not) {
    const std::string reason = text_of(control().text);
    end();
    throw GuestError(fmt::format("{} is no plug-in that can be asked: {}", library, reason));
  }
}

PluginHost::~PluginHost() {
  if (process_ > 0) end();
  if (socket_ >= 0) close(socket_);
  if (printed_ < 0) return;
  pass_on_printed();
  close(printed_);
}

void PluginHost::start(const std::string& library) {
  const std::string host = file_of_program("clipscope_plugin_host").string();
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends) != 0) {
    throw GuestError(fmt::format("no socket for a plug-in: {}", error_text(errno)));
  }
  socket_ = ends[0];
  // What does not fit is lost, so that who prints for ever waits for nobody and fills nothing.
  int pipe[2];
  if (pipe2(pipe, O_CLOEXEC | O_NONBLOCK) != 0) {
    close(ends[1]);
    throw GuestError(fmt::format("no pipe for a plug-in: {}", error_text(errno)));
  }
  printed_ = pipe[0];
  char* const arguments[] = {const_cast<char*>(host.c_str()), const_cast<char*>(library.c_str()),
                             nullptr};
  const FileActions actions(ends[1], pipe[1]);
  const int error =
      posix_spawn(&process_, host.c_str(), actions.get(), nullptr, arguments, environ);
  close(ends[1]);
  close(pipe[1]);
  if (error == 0) return;
  process_ = -1;
  throw GuestError(fmt::format("{}: does not start: {}", host, error_text(error)));
}

std::string PluginHost::read_printed() const {
  std::string text;
  std::array<char, 4096> block;
  for (ssize_t n; (n = read(printed_, block.data(), block.size())) > 0;) {
    text.append(block.data(), static_cast<std::size_t>(n));
  }
  return text;
}

std::string PluginHost::last_printed() const {
  const std::string words = last_words(read_printed());
  return words.empty() ? "" : ", printing: " + words;
}

void PluginHost::pass_on_printed() const {
  const std::string text = read_printed();
  std::fwrite(text.data(), 1, text.size(), stderr);
}

std::optional<Failure> PluginHost::ask(plugin::Order order, double seconds) {
  if (!measured_) pass_on_printed();
  control().order = order;
  plugin::pass(control().asked, ++orders_);
  if (is_answered(seconds)) {
    if (!says_why_it_ends(control())) return {};
    end();
    return failure_of_end();
  }
  if (!has_ended()) {
    end();
    return Failure{Failure::Kind::timed_out,
                   fmt::format("does not end within {:g} s{}", seconds, last_printed())};
  }
  control().fault = plugin::Fault::none;
  return failure_of_end();
}

bool PluginHost::is_answered(double seconds) {
  double awake_us = awake_us_;
  for (double left = seconds; left > 0; left -= kSlice) {
    if (plugin::await(control().answered, orders_, {awake_us, std::min(left, kSlice)})) return true;
    if (has_ended()) return false;
    awake_us = 0;
  }
  return false;
}

std::optional<Failure> PluginHost::hand_over(plugin::Use use, std::size_t index,
                                             const SharedArea& area) {
  const auto place = static_cast<std::uint32_t>(index);
  if (!plugin::send_area(socket_, {use, place, area.size()}, area.file())) {
    end();
    return failure_of_end();
  }
  std::optional<Failure> failure = ask(plugin::Order::take_area, kLoadingSeconds);
  if (!failure && control().fault == plugin::Fault::loads_not) throw std::bad_alloc();
  return failure;
}

void PluginHost::let_run_on(const std::vector<int>& processors) {
  auto& bits = control().processors;
  bits = {};
  for (const int p : processors) {
    const auto bit = static_cast<std::size_t>(p);
    if (bit < 64 * bits.size()) bits[bit / 64] |= std::uint64_t{1} << (bit % 64);
  }
}

// With one processor neither waits awake, since the other one needs it.
void PluginHost::stay_awake(double program_us, double host_us) {
  const bool is_alone = processors_.size() < 2;
  awake_us_ = is_alone ? 0 : program_us;
  control().awake_us = is_alone ? 0 : host_us;
}

void PluginHost::enter_clock() {
  stay_awake(kTimedAwakeUs, kHostAwakeUs);
  const std::vector<int> own = allowed_processors();
  const auto other = std::ranges::find_if(processors_, [&](int p) { return p != own.front(); });
  if (own.size() != 1 || other == processors_.end()) return;
  let_run_on(own);
  if (keep_to(*other)) measured_ = own.front();
}

void PluginHost::leave_clock() {
  stay_awake(0, 0);
  let_run_on(processors_);
  wake(SCHED_OTHER, 0);  // and sleeps again
  stay_awake(kAwakeUs, kAwakeUs);
  if (measured_) keep_to(*measured_);
  measured_.reset();
}

// Makes the host take its class and its processors.
bool PluginHost::wake(int scheduling_class, int priority) {
  control().scheduling_class = scheduling_class;
  control().scheduling_priority = priority;
  return !ask(plugin::Order::wake, kLoadingSeconds);
}

// In the class of the calling thread, which waits for it.
std::int64_t PluginHost::lost_processor() {
  sched_param parameters{};
  sched_getparam(0, &parameters);
  return wake(sched_getscheduler(0), parameters.sched_priority) ? control().lost_processor : 0;
}

bool PluginHost::has_ended() {
  if (process_ > 0 && waitpid(process_, &status_, WNOHANG) == process_) process_ = -1;
  return process_ < 0;
}

// Of its own, if it says so and does so, or by force. What it said before remains.
void PluginHost::end() {
  if (process_ < 0) return;
  double left = says_why_it_ends(control()) ? kEndingSeconds : 0;
  for (; left > 0 && !has_ended(); left -= kSlice / 10) {
    std::this_thread::sleep_for(std::chrono::duration<double>(kSlice / 10));
  }
  if (process_ < 0) return;
  kill(process_, SIGKILL);
  while (waitpid(process_, &status_, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

Failure PluginHost::failure_of_end() const {
  Failure failure = experiments::failure_of_end(control(), status_);
  failure.reason += last_printed();
  return failure;
}

}  // namespace clipscope::experiments
