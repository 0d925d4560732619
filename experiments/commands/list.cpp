// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope list: what there is to select from.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/catalogue/hard_case.hpp"
#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/report/table.hpp"
#include "experiments/scenes/builtin.hpp"
#include "spaces/homogeneous/polygon.hpp"

namespace clipscope::experiments {
namespace {

// ", a, b" for the names whose flag is set; "" for none.
std::string listed(std::string_view before,
                   std::initializer_list<std::pair<bool, const char*>> names) {
  std::string text;
  for (const auto& [is_set, name] : names) {
    if (is_set) text += fmt::format("{}{}", text.empty() ? before : ", ", name);
  }
  return text;
}

std::string promise_text(const Promise& promise) {
  const bool whole = promise.domain == Promise::Domain::all_or_nothing;
  std::string text =
      fmt::format("{} ulp{}", promise.ulps,
                  promise.amplification == Promise::Amplification::w_ratio ? " * w_max/w_min" : "");
  text += listed(", ", {{promise.domain == Promise::Domain::in_front, "in front only"},
                        {whole, "whole triangles"},
                        {!promise.covers, "loses visible parts"},
                        {!promise.contained, "draws outside"},
                        {!promise.attributes, "attributes not promised"}});
  text += listed("; to the bit: ", {{promise.total, "total"},
                                    {promise.watertight, "watertight"},
                                    {promise.rotation_invariant, "rotation"},
                                    {promise.scale_invariant, "scale"},
                                    {promise.correctly_rounded, "correctly rounded"}});
  text += listed("; does not take ", {{!promise.depth_clamp, "depth clamp"},
                                      {!promise.clip_distances, "clip distances"}});
  return text;
}

// C: a contestant, or a clipper.
template <class C>
void add_clipper(Table& table, const C& c, Primitive primitive, bool takes_clip_space) {
  table.add_row({std::string(c.name), to_string(primitive),
                 std::string(takes_clip_space ? "view, clip" : "view"), std::string(c.summary),
                 promise_text(c.promise), std::string(c.source)});
}

template <std::size_t N>
void add_clippers(Table& table, Primitive primitive) {
  for (const Contestant<float, N>& c : contestants<float, N>()) {
    add_clipper(table, c, primitive, c.clip != nullptr);
  }
}

Table clippers_table() {
  Table table("clippers", "Clippers",
              {{"name", "name"},
               {"primitive", "primitive"},
               {"space_inputs", "input"},
               {"summary", "what it does"},
               {"promise", "backward error promised"},
               {"source", "source"}});
  add_clippers<3>(table, Primitive::triangle);
  add_clippers<2>(table, Primitive::segment);
  add_clippers<1>(table, Primitive::point);
  add_clipper(table, HomogeneousPolygonClipper<float, kRunTime>{}, Primitive::polygon, true);
  return table;
}

Table scalars_table() {
  Table table("scalars", "Scalars",
              {{"name", "name"}, {"precision_bits", "bits"}, {"summary", "what it is"}});
  for_each_type(AllScalars{}, [&]<class T>() {
    Cell bits;
    if (ScalarTraits<T>::precision > 0) bits = std::int64_t{ScalarTraits<T>::precision};
    table.add_row(
        {std::string(ScalarTraits<T>::name), bits, std::string(ScalarTraits<T>::summary)});
  });
  return table;
}

Table scenes_table() {
  Table table("scenes", "Built-in scenes (any mesh file is a scene, too)",
              {{"name", "name"}, {"summary", "what it is"}});
  for (const SceneInfo& info : builtin_scenes()) {
    table.add_row({std::string(info.name), std::string(info.description)});
  }
  return table;
}

Table experiments_table() {
  Table table("experiments", "Experiments", {{"name", "name"}, {"question", "question"}});
  for (const Experiment& experiment : all_experiments()) {
    table.add_row({std::string(experiment.name), std::string(experiment.question)});
  }
  return table;
}

// A name a line, then what it is, indented: long texts stay readable.
void print_list(const Table& table) {
  for (const std::vector<Cell>& row : table.rows()) {
    fmt::print("{}\n", std::get<std::string>(row[0]));
    for (std::size_t c = 1; c < row.size(); ++c) {
      if (const auto* text = std::get_if<std::string>(&row[c])) {
        fmt::print("    {}{}\n", c == 1 && row.size() <= 3 ? "" : table.columns()[c].head + ": ",
                   *text);
      }
    }
  }
}

}  // namespace

void add_list_command(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand("list", "List clippers, scalars, scenes or experiments");
  struct Options {
    std::string what;
    bool json = false;
  };
  const auto options = std::make_shared<Options>();
  command->add_option("what", options->what, "What to list")
      ->required()
      ->check(CLI::IsMember({"clippers", "scalars", "scenes", "experiments"}));
  command->add_flag("--json", options->json, "Print JSON");
  command->callback([&action, options] {
    action = [options] {
      const Table table = options->what == "clippers"  ? clippers_table()
                          : options->what == "scalars" ? scalars_table()
                          : options->what == "scenes"  ? scenes_table()
                                                       : experiments_table();
      if (options->json) {
        fmt::print("{}\n", table.to_json()["rows"].dump(2));
      } else {
        print_list(table);
      }
      return int{kExitOk};
    };
  });
}

}  // namespace clipscope::experiments
