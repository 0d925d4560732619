// SPDX-License-Identifier: GPL-3.0-or-later
//
// Prints a checksum of what the batch clippers answer, for each method, layout, depth range and
// kind of numbers: two machines that clip alike print the same. `plain` as argument: the plain
// version. The last line, on the error stream, is the instruction set.
#include <cstdio>
#include <string_view>

#include "tests/spaces/batch/inputs.hpp"

namespace clipscope::batch::tests {
namespace {

constexpr std::size_t kTriangles = 1500;
constexpr int kAttributes = 4;

// FNV-1a (Fowler, Noll and Vo), 64 bits, over words of 32 bits.
class Checksum {
 public:
  void add(std::uint32_t word) { sum_ = (sum_ ^ word) * 0x100000001b3; }
  std::uint64_t value() const { return sum_; }

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325;
};

// The bits of a float; all NaNs are one.
std::uint32_t bits_of(float x) {
  return std::isnan(x) ? 0x7fc00000u : std::bit_cast<std::uint32_t>(x);
}

// Polygons from the vertex with the least bits on: which one comes first is the method's business.
void add_polygon(std::span<const float> polygon, std::size_t stride, Checksum& sum) {
  const auto bits_from = [&](std::size_t first) {
    std::vector<std::uint32_t> bits;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      bits.push_back(bits_of(polygon[(first + i) % polygon.size()]));
    }
    return bits;
  };
  std::vector<std::uint32_t> least = bits_from(0);
  for (std::size_t v = stride; v < polygon.size(); v += stride) {
    least = std::min(least, bits_from(v));
  }
  for (const std::uint32_t word : least) sum.add(word);
}

void print(std::string_view method, std::string_view layout, int numbers, int depth,
           const Output& out) {
  Checksum sum;
  for (const std::uint32_t t : out.inside()) sum.add(t);
  for (std::size_t i = 0; i < out.polygons().size(); ++i) {
    sum.add(out.polygons()[i].triangle);
    add_polygon(out.polygon(i), out.stride(), sum);
  }
  std::printf("%-36.*s %-8.*s numbers %d depth %d: %5zu inside, %5zu polygons, %016llx\n",
              static_cast<int>(method.size()), method.data(), static_cast<int>(layout.size()),
              layout.data(), numbers, depth, out.inside().size(), out.polygons().size(),
              static_cast<unsigned long long>(sum.value()));
}

void print_stages(Build build, const Soup& soup, int numbers) {
  Output out;
  for (const DepthRange depth :
       {DepthRange::minus_one_to_one, DepthRange::zero_to_one, DepthRange::reversed}) {
    for (const Method method : kStageMethods) {
      const auto print_layout = [&](std::string_view layout, const auto& input) {
        clip(method, {.depth = depth}, input, out, build);
        print(name(method), layout, numbers, static_cast<int>(depth), out);
      };
      print_layout("copy", soup.array());
      print_layout("number", soup.streams());
      print_layout("indexed", soup.mesh());
    }
  }
}

// The soup's floats taken for view-space vertices.
void print_full(Build build, const Soup& soup, int numbers) {
  const std::size_t stride = 3 + kAttributes;
  const ViewVertexArray input{soup.vertices.data(), soup.vertices.size() / (3 * stride) * 3,
                              kAttributes};
  Output out;
  for (const Method method : kFullMethods) {
    clip(method, Projection<float>(Frustum<float>{}), input, out, build);
    print(name(method), "full", numbers, 0, out);
  }
}

}  // namespace
}  // namespace clipscope::batch::tests

int main(int argc, char** argv) {
  using namespace clipscope::batch;
  using namespace clipscope::batch::tests;
  const bool plain = argc > 1 && std::string_view(argv[1]) == "plain";
  const Build build = plain ? Build::plain : Build::simd;
  Random random(1);
  for (std::size_t i = 0; i < kNumbers.size(); ++i) {
    const Soup soup = make_soup(random, kNumbers[i], kAttributes, kTriangles);
    print_stages(build, soup, static_cast<int>(i));
    print_full(build, soup, static_cast<int>(i));
  }
  std::fprintf(stderr, "%s\n", plain ? "plain" : target_name().c_str());
}
