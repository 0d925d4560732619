// SPDX-License-Identifier: MIT
#include "spaces/plugin/faults.hpp"

#include <signal.h>
#include <ucontext.h>
#include <unistd.h>

#include <utility>

namespace clipscope::plugin {
namespace {

constexpr std::size_t kStackBytes = 65536;
constexpr std::size_t kThreads = 2;

Control* told = nullptr;
const Memory* watched = nullptr;

Reach::Access access_of([[maybe_unused]] const void* context) {
#if defined(__x86_64__)
  // The processor's error code of a page fault: bit 1 is set for a write.
  const auto& registers = static_cast<const ucontext_t*>(context)->uc_mcontext.gregs;
  return registers[REG_ERR] & 2 ? Reach::Access::write : Reach::Access::read;
#else
  return Reach::Access::unknown;
#endif
}

// Whether the address is in an area or just beside it, which `reach` then says.
bool is_at(const Guarded& area, Use use, const void* address, Reach& reach) {
  const Place place = area.place_of(address);
  if (place == Place::elsewhere) return false;
  reach.use = use;
  reach.side = place == Place::before   ? Reach::Side::before
               : place == Place::inside ? Reach::Side::inside
                                        : Reach::Side::after;
  return true;
}

bool find_reach(const Memory& memory, const void* address, Reach& reach) {
  for (const Guarded& input : memory.inputs) {
    if (is_at(input, Use::input, address, reach)) return true;
  }
  for (const Output& output : memory.outputs) {
    if (is_at(output.projected.read(), Use::input, address, reach) ||
        is_at(output.numbers, Use::output, address, reach) ||
        is_at(output.ends, Use::output_ends, address, reach)) {
      return true;
    }
  }
  return is_at(memory.input_ends, Use::input_ends, address, reach);
}

void on_signal(int number, siginfo_t* info, void* context) {
  Control& control = *told;
  control.fault = Fault::signal;
  control.code = number;
  if ((number == SIGSEGV || number == SIGBUS) &&
      find_reach(*watched, info->si_addr, control.reach)) {
    control.fault = Fault::out_of_bounds;
    control.reach.access = access_of(context);
  }
  pass(control.answered, control.asked.number.load());
  _exit(128 + number);
}

}  // namespace

FaultStack::FaultStack(std::size_t thread) {
  static unsigned char stacks[kThreads][kStackBytes];
  const stack_t stack{.ss_sp = stacks[thread], .ss_flags = 0, .ss_size = kStackBytes};
  stack_t before{};
  sigaltstack(&stack, &before);
  before_ = before.ss_sp;
  before_bytes_ = before.ss_size;
  before_flags_ = before.ss_flags;
}

FaultStack::~FaultStack() {
  const stack_t before{.ss_sp = before_, .ss_flags = before_flags_, .ss_size = before_bytes_};
  sigaltstack(&before, nullptr);
}

void report_faults(Control& control, const Memory& memory) {
  told = &control;
  watched = &memory;
  static const FaultStack stack(0);
  struct sigaction action {};
  action.sa_sigaction = on_signal;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGSYS, SIGTRAP}) {
    sigaction(number, &action, nullptr);
  }
}

}  // namespace clipscope::plugin
