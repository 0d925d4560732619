// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/drawcalls/wire.hpp"

#include <malloc.h>
#include <poll.h>
#include <unistd.h>

#include <bit>
#include <cerrno>
#include <cstring>
#include <thread>
#include <type_traits>
#include <utility>

namespace clipscope::experiments {
namespace {

// What has no invalid values, byte for byte.
template <class T>
concept Plain = (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>);

// What has parts, which fields() names.
template <class T>
concept Record = std::is_same_v<T, DriverInfo> || std::is_same_v<T, DrawVertex> ||
    std::is_same_v<T, Viewport> || std::is_same_v<T, ClipVolume> || std::is_same_v<T, DrawCall> ||
    std::is_same_v<T, Pixels> || std::is_same_v<T, DrawFailure>;

class Writer {
 public:
  std::string bytes;

  template <Plain T>
  void operator()(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void operator()(const bool& value) { (*this)(static_cast<std::uint8_t>(value)); }
  template <class E>
  requires std::is_enum_v<E>
  void operator()(const E& value) { (*this)(static_cast<std::uint8_t>(value)); }
  void operator()(const Quantities& set) { (*this)(static_cast<std::uint32_t>(set.to_ulong())); }
  void operator()(const std::string& text) { elements(text); }
  template <class T, std::size_t n>
  void operator()(const std::array<T, n>& values) {
    for (const T& value : values) (*this)(value);
  }
  template <class T>
  void operator()(const std::vector<T>& values) {
    elements(values);
  }
  template <Record T>
  void operator()(const T& value) {
    fields(value, *this);
  }

 private:
  template <class C>
  void elements(const C& values) {
    (*this)(static_cast<std::uint32_t>(values.size()));
    if constexpr (Plain<typename C::value_type>) {
      bytes.append(reinterpret_cast<const char*>(values.data()),
                   values.size() * sizeof(typename C::value_type));
    } else {
      for (const auto& value : values) (*this)(value);
    }
  }
};

// Once something was not as it should be, `is_good` stays false and values are left as they were.
class Reader {
 public:
  explicit Reader(std::span<const char> bytes) : rest_(bytes) {}

  bool is_good = true;
  bool is_at_end() const { return is_good && rest_.empty(); }

  template <Plain T>
  void operator()(T& value) {
    if (has(sizeof value)) copy(&value, sizeof value);
  }
  void operator()(bool& value) { value = below(2) == 1; }
  void operator()(DepthRange& value) { value = static_cast<DepthRange>(below(3)); }
  template <class E>
  requires std::is_enum_v<E>
  void operator()(E& value) { value = static_cast<E>(below(names_of(E{}).size())); }
  void operator()(Quantities& set) {
    std::uint32_t bits = 0;
    (*this)(bits);
    is_good = is_good && bits >> kQuantities == 0;
    set = Quantities(bits);
  }
  void operator()(std::string& text) { elements(text); }
  template <class T, std::size_t n>
  void operator()(std::array<T, n>& values) {
    for (T& value : values) (*this)(value);
  }
  template <class T>
  void operator()(std::vector<T>& values) {
    elements(values);
  }
  template <Record T>
  void operator()(T& value) {
    fields(value, *this);
  }

 private:
  bool has(std::size_t count) { return is_good = is_good && rest_.size() >= count; }

  std::uint8_t below(std::size_t bound) {
    std::uint8_t value = 0;
    (*this)(value);
    is_good = is_good && value < bound;
    return is_good ? value : std::uint8_t{0};
  }

  // Elements that are not plain have a byte at least.
  template <class C>
  void elements(C& values) {
    using Element = typename C::value_type;
    constexpr std::size_t kLeast = Plain<Element> ? sizeof(Element) : 1;
    std::uint32_t count = 0;
    (*this)(count);
    if (!has(count * kLeast)) return;
    values.resize(count);
    if constexpr (Plain<Element>) {
      copy(values.data(), count * kLeast);
    } else {
      for (auto& value : values) (*this)(value);
    }
  }

  // Pre-condition: there are so many bytes.
  void copy(void* to, std::size_t size) {
    if (size > 0) std::memcpy(to, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }

  std::span<const char> rest_;
};

// The parts of each, in the order in which they lie; T is const or not.
template <class T, class Part>
concept Is = std::is_same_v<std::remove_const_t<T>, Part>;

template <class Each>
void fields(Is<DriverInfo> auto& info, Each& each) {
  each(info.api), each(info.api_version), each(info.renderer), each(info.version);
  each(info.subpixel_bits), each(info.max_size), each(info.max_clip_distances);
  each(info.max_point_size), each(info.minus_one_to_one), each(info.zero_to_one);
  each(info.depth_clamp), each(info.provoking_first), each(info.provoking_last);
  each(info.triangle_fans), each(info.strict_lines), each(info.points_clip_at_sides);
  each(info.quantities);
}

template <class Each>
void fields(Is<DrawVertex> auto& vertex, Each& each) {
  each(vertex.position), each(vertex.varying), each(vertex.clip_distances);
}

template <class Each>
void fields(Is<Viewport> auto& viewport, Each& each) {
  each(viewport.x), each(viewport.y), each(viewport.width), each(viewport.height);
}

// Draw calls have no open sides.
template <class Each>
void fields(Is<ClipVolume> auto& volume, Each& each) {
  each(volume.depth), each(volume.depth_clamp.near), each(volume.depth_clamp.far);
  each(volume.clip_distances);
}

template <class Each>
void fields(Is<DrawCall> auto& call, Each& each) {
  each(call.name), each(call.topology), each(call.vertices), each(call.indices);
  each(call.volume), each(call.provoking), each(call.point_size), each(call.width);
  each(call.height), each(call.viewport), each(call.quantities);
}

template <class Each>
void fields(Is<Pixels> auto& pixels, Each& each) {
  each(pixels.width), each(pixels.height), each(pixels.values);
}

template <class Each>
void fields(Is<DrawFailure> auto& failure, Each& each) {
  each(failure.kind), each(failure.reason);
}

// Which of the two it is, and that one. room: bytes that it is likely to take.
template <class A, class B>
std::string bytes_of(const std::variant<A, B>& either, std::size_t room = 0) {
  Writer write;
  write.bytes.reserve(room);
  write(static_cast<std::uint8_t>(either.index()));
  std::visit([&](const auto& it) { write(it); }, either);
  return std::move(write.bytes);
}

template <class T>
std::optional<T> whole(Reader& read) {
  T value;
  read(value);
  return read.is_at_end() ? std::optional<T>(std::move(value)) : std::nullopt;
}

template <class Either>
std::optional<Either> either_of(std::span<const char> bytes) {
  Reader read(bytes);
  std::uint8_t which = 0;
  read(which);
  if (which == 0) return whole<std::variant_alternative_t<0, Either>>(read);
  if (which == 1) return whole<std::variant_alternative_t<1, Either>>(read);
  return std::nullopt;
}

// Each quantity has a float for every channel of every pixel, or none.
bool is_whole(const Pixels& pixels) {
  if (pixels.width < 1 || pixels.height < 1) return false;
  const std::size_t count =
      static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
  for (std::size_t q = 0; q < kQuantities; ++q) {
    const std::size_t size = pixels.values[q].size();
    if (size != 0 && size != count * channels(static_cast<Quantity>(q))) return false;
  }
  return true;
}

// Reads or writes all of it; the number of bytes that it came to.
template <class Transfer>
std::size_t transfer(std::size_t size, Transfer&& some) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t moved = some(done);
    if (moved < 0 && errno == EINTR) continue;
    if (moved <= 0) break;
    done += static_cast<std::size_t>(moved);
  }
  return done;
}

bool read_all(int file, char* to, std::size_t size) {
  return transfer(size, [&](std::size_t done) { return read(file, to + done, size - done); }) ==
         size;
}

bool write_all(int file, const char* from, std::size_t size) {
  return transfer(size, [&](std::size_t done) { return write(file, from + done, size - done); }) ==
         size;
}

Drawn too_many_pixels() {
  return DrawFailure{DrawFailure::Kind::unable, "has no room for so many pixels"};
}

// A driver that hangs would outlive the program otherwise.
void end_with_program() {
  std::thread([] {
    pollfd end{.fd = kHostSocket, .events = 0, .revents = 0};
    while (poll(&end, 1, -1) <= 0) {
    }
    _exit(0);
  }).detach();
}

}  // namespace

std::string to_bytes(const Greeting& greeting) { return bytes_of(greeting); }
std::string to_bytes(const Drawn& drawn) {
  std::size_t floats = 64;  // room for the rest, too
  if (const auto* pixels = std::get_if<Pixels>(&drawn)) {
    for (const std::vector<float>& values : pixels->values) floats += values.size();
  }
  return bytes_of(drawn, floats * sizeof(float));
}
std::string to_bytes(const DrawCall& call) {
  Writer write;
  write(call);
  return std::move(write.bytes);
}

std::optional<Greeting> greeting_of(std::span<const char> bytes) {
  return either_of<Greeting>(bytes);
}

std::optional<DrawCall> draw_call_of(std::span<const char> bytes) {
  Reader read(bytes);
  return whole<DrawCall>(read);
}

std::optional<Drawn> drawn_of(std::span<const char> bytes) {
  std::optional<Drawn> drawn = either_of<Drawn>(bytes);
  const auto* pixels = drawn ? std::get_if<Pixels>(&*drawn) : nullptr;
  return pixels && !is_whole(*pixels) ? std::nullopt : drawn;
}

std::optional<std::string> read_frame(int file) {
  std::uint32_t size = 0;
  if (!read_all(file, reinterpret_cast<char*>(&size), sizeof size)) return std::nullopt;
  if (size > kMostFrameBytes) return std::nullopt;
  std::string bytes(size, 0);
  if (!read_all(file, bytes.data(), size)) return std::nullopt;
  return bytes;
}

bool write_frame(int file, std::span<const char> bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  return write_all(file, reinterpret_cast<const char*>(&size), sizeof size) &&
         write_all(file, bytes.data(), bytes.size());
}

void keep_memory_of_pixels() {
  constexpr int kOneBlock = 32 << 20, kFree = 256 << 20;  // bytes; the first is the most there is
  mallopt(M_MMAP_THRESHOLD, kOneBlock);
  mallopt(M_TRIM_THRESHOLD, kFree);
}

int serve(Driver* driver, const std::string& reason_for_none) {
  end_with_program();
  keep_memory_of_pixels();
  const Greeting greeting = driver ? Greeting(driver->info()) : Greeting(reason_for_none);
  if (!write_frame(kHostSocket, to_bytes(greeting)) || !driver) return driver ? 1 : 0;
  while (const std::optional<std::string> frame = read_frame(kHostSocket)) {
    const std::optional<DrawCall> call = draw_call_of(*frame);
    if (!call) return 1;
    std::string answer = to_bytes(driver->draw(*call));
    if (answer.size() > kMostFrameBytes) answer = to_bytes(too_many_pixels());
    if (!write_frame(kHostSocket, answer)) return 1;
  }
  return 0;
}

}  // namespace clipscope::experiments
