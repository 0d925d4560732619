// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the parts of a page of results are made from, and the parts that several of its sections
// share.
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

#include "experiments/report/html.hpp"
#include "experiments/report/report.hpp"
#include "experiments/store/results_store.hpp"

namespace clipscope::experiments {

// Experiments whose tables the page knows, and their main tables.
inline constexpr const char *kAnswers = "answers", *kClaims = "claims";

class PageSource {
 public:
  PageSource(const ResultsStore& store, std::filesystem::path directory, PageForm form);

  const ResultsStore& store() const { return store_; }
  // Whether the explorer's page lies beside this one, to lead to.
  bool has_explorer() const;

  // What the page has sections of.
  const std::set<std::string>& parts() const { return parts_; }

  // A table of an experiment's. A long one of a page that has files beside it leaves its rows to
  // one of them.
  std::string table(const Table& table, const std::string& experiment,
                    TableSetting setting = {}) const;
  // The picture with its caption, or that it can't be read.
  std::string plot(const StoredFigure& figure) const;
  std::string picture(const StoredFigure& figure) const;

  // The files that the parts made so far need, by their addresses.
  const std::map<std::string, std::string>& scripts() const { return scripts_; }

 private:
  std::string linked_plot(const StoredFigure& figure, const std::string& text) const;

  const ResultsStore& store_;
  std::filesystem::path directory_;
  PageForm form_;
  std::set<std::string> parts_;
  mutable std::map<std::string, std::string> scripts_;
};

// The first screen: the run's answers, each with its evidence. Nothing, where the run was not asked
// for them. See experiments/answers.
std::string answers_html(const PageSource& source);

// How many claims got which verdict.
std::string tally_html(const Table& claims);

// The table of claims; the figures that decide one, if the run has them, fold out beneath its
// reason.
std::string claims_html(const PageSource& source, const Table& claims);

}  // namespace clipscope::experiments
