// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope list: what there is to select from.
#include <fmt/format.h>

#include <memory>

#include "experiments/commands/commands.hpp"
#include "experiments/commands/selection.hpp"
#include "experiments/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/report/table.hpp"
#include "experiments/scenes/builtin.hpp"

namespace clipscope::experiments {
namespace {

std::string promise_text(const Promise& promise) {
  const bool whole = promise.domain == Promise::Domain::all_or_nothing;
  std::string text =
      fmt::format("{} ulp{}", promise.ulps,
                  promise.amplification == Promise::Amplification::w_ratio ? " * w_max/w_min" : "");
  if (promise.domain == Promise::Domain::in_front) text += ", in front only";
  if (whole) text += ", whole triangles";
  if (!promise.covers) text += ", loses visible parts";
  if (!promise.contained) text += ", draws outside";
  if (!promise.attributes) text += ", attributes not promised";
  return text;
}

Table clippers_table() {
  Table table("clippers", "Clippers",
              {{"name", "name"},
               {"space_inputs", "input"},
               {"summary", "what it does"},
               {"promise", "backward error promised"},
               {"source", "source"}});
  for (const Contestant<float>& c : contestants<float>()) {
    table.add_row({std::string(c.name), std::string(c.clip ? "view, clip" : "view"),
                   std::string(c.summary), promise_text(c.promise), std::string(c.source)});
  }
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
