// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope_misbehaving_host [GREETING]: a host that does what the name of a draw call says, and
// greets as its argument says. Its version is the number of its process.
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "experiments/drawcalls/wire.hpp"

namespace clipscope::experiments {
namespace {

constexpr char kNonsense[] = "\4\0\0\0abcd";  // a frame that holds no answer
constexpr int kBytesOfNonsense = 8;

void say_nonsense() {
  if (write(kHostSocket, kNonsense, kBytesOfNonsense) != kBytesOfNonsense) std::abort();
}

class Misbehaving : public Driver {
 public:
  Misbehaving() {
    info_.renderer = "misbehaving";
    info_.version = std::to_string(getpid());
    info_.max_size = 1000;
    info_.minus_one_to_one = true;
  }
  const DriverInfo& info() const override { return info_; }

  Drawn draw(const DrawCall& call) override {
    if (call.name == "crash") {
      std::fputs("mine: an invariant is broken\n", stderr);
      std::abort();
    }
    if (call.name == "hang") pause();
    if (call.name == "end") std::exit(3);
    if (call.name == "nonsense") say_nonsense();
    if (call.name == "too_long") write_frame(kHostSocket, std::vector<char>(3)), say_nonsense();
    if (call.name == "refuse") return DrawFailure{DrawFailure::Kind::refused, "GL_OUT_OF_MEMORY"};
    if (call.name == "print") {
      for (int i = 0; i < 100'000; ++i) std::puts("a driver that talks a lot");
    }
    Pixels pixels{call.width, call.height};
    const std::size_t count =
        static_cast<std::size_t>(call.width) * static_cast<std::size_t>(call.height);
    pixels.values[bit(Quantity::covered)].assign(count, 1);
    if (call.name != "half") pixels.values[bit(Quantity::hits)].assign(2 * count, 1);
    if (call.name == "small") pixels = {1, 1, {{{1}, {1, 1}}}};
    return pixels;
  }

 private:
  DriverInfo info_;
};

int live(const std::string& greeting) {
  if (greeting == "end") return 4;
  if (greeting == "hang") pause();
  if (greeting == "nonsense") say_nonsense();
  if (greeting == "none") return serve(nullptr, "no display can be opened");
  Misbehaving driver;
  return serve(&driver, "");
}

}  // namespace
}  // namespace clipscope::experiments

int main(int count, char** words) {
  return clipscope::experiments::live(count > 1 ? words[1] : "");
}
