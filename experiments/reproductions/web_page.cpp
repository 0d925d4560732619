// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page draws with the script that the audit itself draws with.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>

#include "experiments/backends/webgl/webgl_call.hpp"
#include "experiments/reproductions/formats.hpp"
#include "experiments/reproductions/page_text.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kLeastAttachments = 4;  // that WebGL 2 has everywhere

// Extensions that the call can't be drawn without.
std::vector<std::string_view> needs(const DrawCall& call, const Check& check) {
  std::vector<std::string_view> names;
  if (call.volume.depth_clamp) names.emplace_back("'EXT_depth_clamp'");
  if (call.volume.depth == DepthRange::zero_to_one) names.emplace_back("'EXT_clip_control'");
  if (call.volume.clip_distances > 0) names.emplace_back("'WEBGL_clip_cull_distance'");
  if (check.quantity == Quantity::noperspective) {
    names.emplace_back("'NV_shader_noperspective_interpolation'");
  }
  if (check.quantity == Quantity::flat && call.provoking == ProvokingVertex::first) {
    names.emplace_back("'WEBGL_provoking_vertex'");
  }
  return names;
}

// Where what is checked lies among what is read back.
struct Place {
  std::size_t pass = 0, output = 0, channels = 1, channel = 0;
};
Place place_of(const Check& check, const std::vector<Pass>& passes) {
  const bool is_count = check.kind == Check::Kind::fragments;
  const Quantity sought = !is_count        ? check.quantity
                          : check.counts() ? Quantity::hits
                                           : Quantity::covered;
  const std::size_t channel = is_count ? 0 : check.channel;
  for (std::size_t p = 0; p < passes.size(); ++p) {
    const std::vector<Output>& outputs = passes[p].outputs;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      const Output& output = outputs[k];
      const bool has_it = output.quantity == sought && channel >= output.first &&
                          channel < output.first + output.channels;
      if (has_it) return {p, k, output.channels, channel - output.first};
    }
    if (sought == Quantity::depth && passes[p].has_depth) return {p, outputs.size()};
  }
  return {};
}

std::string_view region_name(Check::Region region) {
  constexpr std::array<std::string_view, 4> kNames = {"pixel", "column", "row", "target"};
  return kNames[static_cast<std::size_t>(region)];
}

std::string check_text(const DrawCall& call, const Check& check, const std::vector<Pass>& passes) {
  const Place place = place_of(check, passes);
  const bool is_count = check.kind == Check::Kind::fragments;
  double least = check.least, greatest = check.greatest;
  if (is_count) {
    least = check.comparison() == "<=" ? 0 : check.fragments;
    greatest = check.comparison() == ">=" ? 1e9 : check.fragments;
  }
  return fmt::format(
      "{{ region: '{}', x: {}, y: {}, pass: {}, output: {}, channels: {}, channel: {}, least: {}, greatest: {},\n"
      "  endsOnly: {}, needs: [{}] }}",
      region_name(check.region), check.x, check.y, place.pass, place.output, place.channels,
      place.channel, least, greatest, check.kind == Check::Kind::ends,
      fmt::join(needs(call, check), ", "));
}

void replace(std::string& text, std::string_view mark, std::string_view by) {
  for (std::size_t at = text.find(mark); at != std::string::npos;
       at = text.find(mark, at + by.size())) {
    text.replace(at, mark.size(), by);
  }
}

// In the depth range of WebGL itself where it converts exactly, so that it needs no extension.
DrawCall drawn_call(const Case& it) {
  DrawCall call = in_depth_range(it.call, DepthRange::minus_one_to_one).value_or(it.call);
  call.quantities = {};
  const bool is_read =
      it.check.kind != Check::Kind::fragments ||
      (it.check.quantity != Quantity::covered && it.check.quantity != Quantity::hits);
  if (is_read) call.quantities.set(bit(it.check.quantity));
  return call;
}

}  // namespace

std::string web_page(const Case& it) {
  if (it.check.quantity == Quantity::primitive_id) return {};
  const DrawCall call = drawn_call(it);
  const std::vector<Pass> passes = webgl_passes(call, kLeastAttachments);
  std::string text = kPage;
  replace(text, "@ABOUT@", xml_escaped(fmt::format("{}", fmt::join(it.about, "\n"))));
  replace(text, "@NAME@", xml_escaped(it.call.name));
  replace(text, "@SUBJECT@", xml_escaped(subject_of(it.check)));
  replace(text, "@DEMAND@", xml_escaped(demand_of(it.check)));
  replace(text, "@CALL@", webgl_call(call, passes));
  replace(text, "@CHECK@", check_text(call, it.check, passes));
  replace(text, "@DRAWING@", webgl_drawing());
  return text;
}

}  // namespace clipscope::experiments
