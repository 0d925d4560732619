// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <string>

#include "experiments/contestants/contestant.hpp"
#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

std::vector<std::string_view> clipper_names() {
  std::vector<std::string_view> names;
  for (const Contestant<float>& contestant : contestants<float>()) {
    names.push_back(contestant.name);
  }
  return names;
}

std::vector<std::string_view> scalar_names() {
  std::vector<std::string_view> names;
  for_each_type(AllScalars{}, [&]<class T>() { names.push_back(ScalarTraits<T>::name); });
  return names;
}

bool matches(std::string_view pattern, std::string_view name) {
  const std::string p(pattern);
  const std::string n(name);
  if (fnmatch(p.c_str(), n.c_str(), 0) == 0) {
    return true;
  }
  return n.starts_with(p + "/") || n.ends_with("/" + p);
}

// Indices into the list of clippers.
std::vector<std::size_t> matching_clippers(std::string_view pattern) {
  const std::vector<std::string_view> names = clipper_names();
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (matches(pattern, names[i])) {
      indices.push_back(i);
    }
  }
  if (indices.empty()) {
    throw UsageError(fmt::format("--clipper: no clipper matches '{}'; there are: {}", pattern,
                                 fmt::join(names, ", ")));
  }
  return indices;
}

void check_scalar(std::string_view scalar) {
  const std::vector<std::string_view> names = scalar_names();
  if (std::find(names.begin(), names.end(), scalar) == names.end()) {
    throw UsageError(fmt::format("--scalar: no scalar is called '{}'; there are: {}", scalar,
                                 fmt::join(names, ", ")));
  }
}

AnyContestant contestant_at(std::size_t clipper, std::string_view scalar) {
  AnyContestant found;
  for_each_type(AllScalars{}, [&]<class T>() {
    if (ScalarTraits<T>::name == scalar) {
      found = &contestants<T>()[clipper];
    }
  });
  return found;
}

template <class T>
std::string_view scalar_of(const Contestant<T>*) {
  return ScalarTraits<T>::name;
}

}  // namespace

std::string_view clipper_name(const AnyContestant& contestant) {
  return std::visit([](const auto* c) { return c->name; }, contestant);
}

std::string_view scalar_name(const AnyContestant& contestant) {
  return std::visit([](const auto* c) { return scalar_of(c); }, contestant);
}

std::vector<AnyContestant> select_contestants(std::string_view clipper_pattern,
                                              const std::vector<std::string>& scalars) {
  std::vector<AnyContestant> selected;
  std::for_each(scalars.begin(), scalars.end(), check_scalar);
  for (const std::size_t clipper : matching_clippers(clipper_pattern)) {
    for (const std::string& scalar : scalars) {
      selected.push_back(contestant_at(clipper, scalar));
    }
  }
  return selected;
}

AnyContestant find_contestant(std::string_view clipper, std::string_view scalar) {
  check_scalar(scalar);
  const std::vector<std::size_t> clippers = matching_clippers(clipper);
  if (clippers.size() > 1) {
    std::vector<std::string_view> names;
    for (const std::size_t i : clippers) {
      names.push_back(clipper_names()[i]);
    }
    throw UsageError(fmt::format("--clipper: '{}' matches several clippers, name one of: {}",
                                 clipper, fmt::join(names, ", ")));
  }
  return contestant_at(clippers.front(), scalar);
}

}  // namespace clipscope::experiments
