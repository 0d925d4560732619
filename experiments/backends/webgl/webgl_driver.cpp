// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/webgl/webgl_driver.hpp"

#include <cstring>
#include <utility>

#include "experiments/backends/webgl/webgl_call.hpp"
#include "experiments/machine/base64.hpp"

namespace clipscope::experiments {
namespace {

using nlohmann::json;

Quantities quantities_of(const json& said) {
  Quantities all;
  for (const Quantity quantity :
       {Quantity::covered, Quantity::hits, Quantity::smooth, Quantity::flat, Quantity::frag_coord,
        Quantity::facing, Quantity::depth}) {
    all.set(bit(quantity));
  }
  all[bit(Quantity::noperspective)] = said.at("noperspective").get<bool>();
  all[bit(Quantity::clip_distances)] = said.at("maxClipDistances").get<int>() > 0;
  return all;
}

DriverInfo info_of(const json& said, const std::string& product) {
  DriverInfo info = {.api = GraphicsApi::webgl,
                     .api_version = said.at("version"),
                     .renderer = said.at("renderer"),
                     .version = product};
  info.subpixel_bits = said.at("subpixelBits");
  info.max_size = said.at("maxSize");
  info.max_clip_distances = said.at("maxClipDistances");
  info.max_point_size = said.at("maxPointSize");
  info.minus_one_to_one = true;
  info.zero_to_one = said.at("clipControl");
  info.depth_clamp = said.at("depthClamp");
  info.provoking_first = said.at("provokingVertex");
  info.provoking_last = true;
  info.quantities = quantities_of(said);
  return info;
}

// The floats in base64, so many; empty where it is anything else.
std::vector<float> floats_of(const json& text, std::size_t count) {
  const std::optional<std::string> bytes = decode_base64(text.get_ref<const std::string&>());
  if (!bytes || bytes->size() != count * sizeof(float)) return {};
  std::vector<float> values(count);
  std::memcpy(values.data(), bytes->data(), bytes->size());
  return values;
}

// Puts the channels of an output in their place among the quantity's.
bool add_output(const Output& output, const json& text, Pixels& pixels) {
  const auto size =
      static_cast<std::size_t>(pixels.width) * static_cast<std::size_t>(pixels.height);
  const std::vector<float> read = floats_of(text, size * output.channels);
  const std::size_t all = channels(output.quantity);
  std::vector<float>& values = pixels.values[bit(output.quantity)];
  values.resize(size * all);
  for (std::size_t i = 0; i < read.size(); ++i) {
    values[i / output.channels * all + output.first + i % output.channels] = read[i];
  }
  return !read.empty();
}

Drawn drawn_of(const DrawCall& call, const std::vector<Pass>& passes, const json& said) {
  Pixels pixels{call.width, call.height};
  bool is_whole = said.size() == passes.size();
  for (std::size_t i = 0; is_whole && i < passes.size(); ++i) {
    std::vector<Output> outputs = passes[i].outputs;
    if (passes[i].has_depth) outputs.push_back({.quantity = Quantity::depth});
    is_whole = said[i].size() == outputs.size();
    for (std::size_t k = 0; is_whole && k < outputs.size(); ++k) {
      is_whole = add_output(outputs[k], said[i][k], pixels);
    }
  }
  if (!is_whole) return DrawFailure{DrawFailure::Kind::refused, "it read back fewer pixels"};
  // Of a call without clip distances they are 0, and no shader can say so.
  if (call.quantities[bit(Quantity::clip_distances)]) {
    pixels.values[bit(Quantity::clip_distances)].resize(pixels.of(Quantity::covered).size() *
                                                        channels(Quantity::clip_distances));
  }
  return pixels;
}

}  // namespace

WebglDriver::WebglDriver(std::vector<std::string> options) : options_(std::move(options)) {
  start();
}

void WebglDriver::start() {
  browser_ = std::make_unique<Browser>(options_);
  browser_->evaluate(webgl_drawing());
  browser_->evaluate(webgl_host());
  const json said = browser_->evaluate("describe()");
  if (said.contains("error")) throw NoBrowser(said["error"].get<std::string>());
  info_ = info_of(said, browser_->product());
  most_attachments_ = said.at("maxAttachments");
}

Drawn WebglDriver::draw(const DrawCall& call) {
  const std::vector<Pass> passes = webgl_passes(call, most_attachments_);
  try {
    if (!browser_) start();
    const json said = browser_->evaluate("answer(" + webgl_call(call, passes) + ")");
    if (!said.contains("error")) return drawn_of(call, passes, said.at("passes"));
    const bool is_lost = said.value("isLost", false);
    return DrawFailure{is_lost ? DrawFailure::Kind::crashed : DrawFailure::Kind::refused,
                       said["error"].get<std::string>()};
  } catch (const std::exception& error) {
    browser_.reset();
    return DrawFailure{DrawFailure::Kind::crashed, error.what()};
  }
}

}  // namespace clipscope::experiments
