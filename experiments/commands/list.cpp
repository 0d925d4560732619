// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope list: what there is to select from.
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "experiments/audit/draw_text.hpp"
#include "experiments/backends/known_drivers.hpp"
#include "experiments/catalogue/hard_case.hpp"
#include "experiments/commands/guest_options.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/json_text.hpp"

namespace clipscope::experiments::commands {
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

// Of a guest: what it takes, for it promises nothing.
std::string promise_text(const Contestant& contestant) {
  const Promise& promise = contestant.promise;
  const std::string lacks = listed("; does not take ", {{!promise.depth_clamp, "depth clamp"},
                                                        {!promise.clip_distances, "clip distances"},
                                                        {!promise.open_sides, "open sides"}});
  if (contestant.is_guest) return "none" + lacks;
  const bool whole = promise.domain == Promise::Domain::all_or_nothing;
  std::string text =
      fmt::format("{} ulp{}", promise.ulps,
                  promise.amplification == Promise::Amplification::w_ratio ? " * w_max/w_min" : "");
  if (promise.ulps == kUnbounded) text = "exact in exact arithmetic, no bound in rounded";
  text += listed(", ", {{promise.domain == Promise::Domain::in_front, "in front only"},
                        {whole, "whole triangles"},
                        {!promise.covers, "loses visible parts"},
                        {!promise.contained, "draws outside"},
                        {!promise.attributes, "attributes not promised"}});
  text += listed("; to the bit: ", {{promise.total, "total"},
                                    {promise.watertight, "watertight"},
                                    {promise.rotation_invariant, "rotation"},
                                    {promise.scale_invariant, "scale"},
                                    {promise.constants, "constants"},
                                    {promise.confined, "confined"},
                                    {promise.correctly_rounded, "correctly rounded"}});
  return text + lacks;
}

// In the first scalar that it is there in.
const Contestant& contestant_of(std::string_view clipper, int vertices) {
  return *select_contestants(clipper, {kFormat<float>.name.data(), kFormat<double>.name.data()},
                             vertices)
              .front();
}

Table clippers_table() {
  Table table("clippers", "Clippers",
              {{"name", "name"},
               {"primitive", "primitive"},
               {"space_inputs", "input"},
               {"summary", "what it does"},
               {"promise", "backward error promised"},
               {"source", "source"}});
  for (const Primitive primitive :
       {Primitive::triangle, Primitive::segment, Primitive::point, Primitive::polygon}) {
    const int vertices = static_cast<int>(vertices_of(primitive));
    for (const std::string_view name : clipper_names(vertices)) {
      const Contestant& c = contestant_of(name, vertices);
      table.add_row({std::string(name), to_string(primitive),
                     c.takes_clip_space ? "view, clip" : "view", std::string(c.summary),
                     promise_text(c), std::string(c.source)});
    }
  }
  return table;
}

Table scalars_table() {
  Table table("scalars", "Scalars",
              {{"name", "name"}, {"precision_bits", "bits"}, {"summary", "what it is"}});
  for_each_type(AllScalars{}, [&]<class T>() {
    const Format& f = kFormat<T>;
    table.add_row({std::string(f.name), f.is_exact() ? Cell() : std::int64_t{f.precision},
                   std::string(f.summary)});
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
  for (const Experiment* e : all_experiments()) {
    table.add_row({std::string(e->name), std::string(e->question)});
  }
  return table;
}

Table drivers_table() {
  Table table("drivers", "Graphics drivers",
              {{"name", "name"},
               {"api", "API"},
               {"renderer", "calls itself"},
               {"version", "version"},
               {"subpixel_bits", "sub-pixel bits"},
               {"missing", "not here"}});
  for (const auto& [driver, info, reason] : drivers_here()) {
    if (info) {
      table.add_row({driver.name, api_text(*info), info->renderer, info->version,
                     std::to_string(info->subpixel_bits), Cell()});
    } else {
      table.add_row({driver.name, Cell(), Cell(), Cell(), Cell(), reason});
    }
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

struct ListOptions {
  std::string what;
  GuestOptions guests;
  bool json = false;
};

int list(const ListOptions& options) {
  load_guests(options.guests);
  const Table table = options.what == "clippers"  ? clippers_table()
                      : options.what == "scalars" ? scalars_table()
                      : options.what == "scenes"  ? scenes_table()
                      : options.what == "drivers" ? drivers_table()
                                                  : experiments_table();
  if (options.json) {
    fmt::print("{}\n", json_text(table.to_json()["rows"], 2));
  } else {
    print_list(table);
  }
  return kExitOk;
}

}  // namespace

void add_list_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, list, "list", "List clippers, scalars, scenes, experiments or graphics drivers");
  command.add_option("what", options.what, "What to list")
      ->required()
      ->check(CLI::IsMember({"clippers", "scalars", "scenes", "experiments", "drivers"}));
  add_guest_options(command, options.guests);
  command.add_flag("--json", options.json, "Print JSON");
}

}  // namespace clipscope::experiments::commands
