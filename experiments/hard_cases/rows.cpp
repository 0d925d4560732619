// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/rows.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

namespace clipscope::experiments::hard_cases {
namespace {

// The outcomes of a row of the matrix, one letter per clipper.
constexpr std::string_view kLetters = "=~.v#MXFNCTA-";
static_assert(kLetters.size() == kOutcomes);
constexpr std::string_view kLetterNote =
    "= exact, ~ faithful (1 ulp), . subpixel (< 1/256 px), v visible, # another number of vertices, M missing, X extra, F flipped, N not finite, C crashed, T timed out, A no answer by its form, - not applicable, blank: not in this scalar.";

char letter(Outcome outcome) { return kLetters[static_cast<std::size_t>(outcome)]; }

// Clippers in the order of their letters, without repetition.
std::vector<std::string_view> clippers_of(const CaseSet& set) {
  std::vector<std::string_view> names;
  for (const Contestant* c : set.contestants) {
    if (names.empty() || names.back() != c->clipper) names.push_back(c->clipper);
  }
  return names;
}

}  // namespace

Table matrix_table(const CaseSet& set, const std::vector<std::string>& scalars) {
  const std::string primitive = to_string(set.primitive);
  std::vector<Column> columns = {{"case", "case"}, {"expected", "exact"}};
  for (const std::string& scalar : scalars) columns.push_back({scalar, scalar});
  Table table(fmt::format("hard_cases_{}s", primitive),
              fmt::format("Verdicts on {}s, one letter per clipper", primitive), columns);
  table.add_note(std::string(kLetterNote));
  table.add_note(fmt::format("Letters in the order of: {}.", fmt::join(clippers_of(set), ", ")));
  return table;
}

void add_matrix(const CaseSet& set, const Verdicts& verdicts,
                const std::vector<std::string>& scalars, Table& table) {
  const std::vector<std::string_view> clippers = clippers_of(set);
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    std::map<std::string_view, std::string> letters;  // of a scalar; blank: no such contestant
    for (const std::string& scalar : scalars) letters[scalar].assign(clippers.size(), ' ');
    for (std::size_t c = 0; c < set.contestants.size(); ++c) {
      const auto place = std::ranges::find(clippers, set.contestants[c]->clipper);
      letters[set.contestants[c]->scalar()][static_cast<std::size_t>(place - clippers.begin())] =
          letter(verdicts[i][c].comparison.outcome);
    }
    std::vector<Cell> cells = {set.cases[i]->name, to_string(set.cases[i]->expected)};
    for (const std::string& scalar : scalars) cells.emplace_back(letters[scalar]);
    table.add_row(std::move(cells));
  }
}

void add_rows(const CaseSet& set, const Verdicts& verdicts, TableOf<VerdictRow>& table) {
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    for (std::size_t c = 0; c < set.contestants.size(); ++c) {
      const auto& [comparison, promise] = verdicts[i][c];
      const bool comparable = comparison.outcome <= Outcome::visible;
      table.add({.hard_case = set.cases[i]->name,
                 .clipper = std::string(set.contestants[c]->clipper),
                 .scalar = std::string(set.contestants[c]->scalar()),
                 .outcome = comparison.outcome,
                 .errors = comparable ? std::optional(comparison) : std::nullopt,
                 .broken_promise = promise.reason});
    }
  }
}

void add_rows(const CaseSet& set, const Verdicts& verdicts, TableOf<SummaryRow>& table) {
  constexpr std::int64_t kNamed = 3;
  for (std::size_t c = 0; c < set.contestants.size(); ++c) {
    SummaryRow row{.primitive = set.primitive,
                   .clipper = std::string(set.contestants[c]->clipper),
                   .scalar = std::string(set.contestants[c]->scalar())};
    for (std::size_t i = 0; i < set.cases.size(); ++i) {
      const auto& [comparison, promise] = verdicts[i][c];
      if (comparison.outcome == Outcome::not_applicable) continue;
      ++row.cases;
      row.promises_broken += promise.verdict == PromiseVerdict::broken;
      if (!is_failure(comparison.outcome)) continue;
      if (row.failures < kNamed) row.failing += (row.failures > 0 ? ", " : "") + set.cases[i]->name;
      ++row.failures;
    }
    if (row.failures > kNamed) row.failing += ", ...";
    table.add(row);
  }
}

std::vector<std::string> caught_by(reference::Bug bug, std::span<const HardCase> cases) {
  std::vector<std::string> names;
  for (const HardCase& c : cases) {
    if (reference::catches(bug, truth_of(c), c.vertices, c.attribute_count)) {
      names.push_back(c.name);
    }
  }
  return names;
}

std::vector<MutantRow> mutant_rows(std::span<const HardCase> cases) {
  std::vector<std::vector<std::string>> caught;
  std::map<std::string, int> bugs_caught;
  for (const reference::BugInfo& info : reference::all_bugs()) {
    for (const std::string& name : caught.emplace_back(caught_by(info.bug, cases))) {
      ++bugs_caught[name];
    }
  }
  std::vector<MutantRow> rows;
  for (const reference::BugInfo& info : reference::all_bugs()) {
    const std::vector<std::string>& names = caught[rows.size()];
    const auto sharpest =
        std::ranges::min_element(names, {}, [&](const auto& name) { return bugs_caught[name]; });
    rows.push_back({std::string(info.summary), static_cast<std::int64_t>(names.size()),
                    sharpest == names.end() ? "" : *sharpest});
  }
  return rows;
}

void add_rows(const UlpGrid& grid, TableOf<SignRow>& table) {
  const SignMap exact = sign_map(grid, grid.exact);
  for (const Predicate& predicate : grid.predicates) {
    table.add({grid.title, predicate.title, compare(sign_map(grid, predicate.sign_of), exact)});
  }
}

}  // namespace clipscope::experiments::hard_cases
