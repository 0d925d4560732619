// SPDX-License-Identifier: GPL-3.0-or-later
//
// Starting a process: the files and the environment that it gets, and what is said of its end.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace clipscope::experiments {

// An open file, closed at the end.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  ~Descriptor();
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

struct Pipe {
  Descriptor read_end, write_end;
};

// Closed in every process that is started but where it is given a number of its own. Errors:
// GuestError.
Pipe open_pipe();

// A file of ours that the process has as `number`.
struct GivenFile {
  int ours, number;
};

// environment: "NAME=value" that it has besides ours, in place of those of that name; ours whose
// name begins with `hidden` it does not have, unless that is empty.
std::vector<std::string> environment_with(std::span<const std::string> environment,
                                          std::string_view hidden = {});

// Starts the program, which leads a process group of its own, so that all of it can be ended.
// words: its name and arguments. files: in ascending order of number, so that none takes the place
// of one that is still to be given. Errors: GuestError.
pid_t start_process(const std::string& program, std::vector<std::string> words,
                    std::vector<std::string> environment, std::span<const GivenFile> files);

// Whether it ends in time; it can still be waited for.
bool ends_before(pid_t process, std::chrono::steady_clock::time_point deadline);

// Ends all of the process's group. Returns how the process ended, as waitpid tells it.
int end_group(pid_t process);

// "SIGSEGV".
std::string signal_text(int number);

// The last three lines that say something of what it printed: "a | b | c", made visible, 300 bytes
// at most; empty if there are none.
std::string last_words(std::string_view printed);
// The same as a remark: " (standard error: a | b)"; empty if there are none.
std::string last_errors(std::string_view printed);

// A program or library of ours: beside this one, or where either is installed or built; empty if it
// is nowhere there.
std::filesystem::path file_beside_program(const std::string& name);
// This one's folder, for messages.
std::filesystem::path folder_of_program();

}  // namespace clipscope::experiments
