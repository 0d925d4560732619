// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers (spaces/batch) as contestants of the full contract, in float: view space in,
// NDC out. They take clip-space triangles as a stage (stages.cpp), not here.
#include <memory>
#include <vector>

#include "experiments/contestants/typed.hpp"
#include "spaces/batch/methods.hpp"

namespace clipscope::experiments {
namespace {

std::vector<float> numbers_in_float(const Batch& b) {
  const VertexReader<Space::view, float, kRunTime> read(b);
  std::vector<float> numbers;
  for (std::size_t i = 0; i < 3 * b.size(); ++i) {
    const auto& [p, attributes] = read(i);
    numbers.insert(numbers.end(), {p[0], p[1], p[2]});
    for (int k = 0; k < attributes.size(); ++k) numbers.push_back(attributes[k]);
  }
  return numbers;
}

class BatchRunner final : public Runner {
 public:
  BatchRunner(batch::Method method, std::span<const Batch> batches) : method_(method) {
    for (const Batch& b : batches) {
      Part& part = parts_.emplace_back();
      part.projection = projection_in<float>(b);
      part.attributes = b.attributes + static_cast<int>(b.planes.size());
      const auto* floats = std::get_if<std::span<const float>>(&b.numbers);
      if (floats != nullptr && b.planes.empty()) {
        part.vertices = floats->data();
        continue;
      }
      part.made = numbers_in_float(b);
      part.vertices = part.made.data();
    }
  }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    const Part& part = parts_[batch];
    const std::size_t stride = 3 + static_cast<std::size_t>(part.attributes);
    batch::clip(method_, part.projection,
                {part.vertices + 3 * first * stride, 3 * count, part.attributes}, out_);
    count_ = count;
  }

  Answers answers() const override {
    Answers answers(kFormat<float>, out_.stride());
    std::size_t next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (next < out_.polygons().size() && out_.polygons()[next].triangle == i) {
        for (const float x : out_.polygon(next++)) answers.add(x);
      }
      answers.end_polygon();
    }
    return answers;
  }

 private:
  struct Part {
    Projection<float> projection = {};
    int attributes = 0;
    const float* vertices = nullptr;
    std::vector<float> made = {};  // where the batch is not as the clipper takes it
  };

  batch::Method method_;
  std::vector<Part> parts_;
  batch::Output out_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<Contestant> made_in_batches() {
  std::vector<Contestant> all;
  for_each_type(batch::AllMethods{}, [&]<class M>() {
    if constexpr (batch::HasFull<M>) {
      Contestant& contestant = all.emplace_back(describe<M>(kFormat<float>));
      contestant.build = "simd";
      contestant.prepare = [](std::span<const Batch> batches) {
        return std::make_unique<BatchRunner>(batch::kMethod<M>, batches);
      };
    }
  });
  return all;
}

}  // namespace clipscope::experiments
