// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <optional>
#include <string>

#include "experiments/contestants/contestant.hpp"
#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

template <std::size_t N>
std::vector<std::string_view> clipper_names() {
  std::vector<std::string_view> names;
  for (const Contestant<float, N>& contestant : contestants<float, N>()) {
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

template <std::size_t N>
std::vector<std::string_view> matching_clippers(std::string_view pattern) {
  std::vector<std::string_view> matching;
  for (const std::string_view name : clipper_names<N>()) {
    if (name == pattern) return {name};
    if (matches(pattern, name)) matching.push_back(name);
  }
  if (matching.empty()) {
    throw UsageError(fmt::format("--clipper: no clipper matches '{}'; there are: {}", pattern,
                                 fmt::join(clipper_names<N>(), ", ")));
  }
  return matching;
}

void check_scalar(std::string_view scalar) {
  const std::vector<std::string_view> names = scalar_names();
  if (std::find(names.begin(), names.end(), scalar) == names.end()) {
    throw UsageError(fmt::format("--scalar: no scalar is called '{}'; there are: {}", scalar,
                                 fmt::join(names, ", ")));
  }
}

// Nothing for a clipper that there is not in that scalar.
template <std::size_t N>
std::optional<AnyContestantOf<N>> contestant_named(std::string_view clipper,
                                                   std::string_view scalar) {
  std::optional<AnyContestantOf<N>> found;
  for_each_type(AllScalars{}, [&]<class T>() {
    if (ScalarTraits<T>::name != scalar) return;
    for (const Contestant<T, N>& contestant : contestants<T, N>()) {
      if (contestant.name == clipper) found = &contestant;
    }
  });
  return found;
}

template <class T>
std::string_view scalar_of(const Contestant<T>*) {
  return ScalarTraits<T>::name;
}

}  // namespace

std::string_view scalar_name(const AnyContestant& contestant) {
  return std::visit([](const auto* c) { return scalar_of(c); }, contestant);
}

std::vector<AnyContestant> select_contestants(std::string_view clipper_pattern,
                                              const std::vector<std::string>& scalars) {
  std::vector<AnyContestant> selected;
  std::for_each(scalars.begin(), scalars.end(), check_scalar);
  for (const std::string_view clipper : matching_clippers<3>(clipper_pattern)) {
    for (const std::string& scalar : scalars) {
      if (const auto contestant = contestant_named<3>(clipper, scalar)) {
        selected.push_back(*contestant);
      }
    }
  }
  if (selected.empty()) {
    throw UsageError(fmt::format("--clipper: '{}' does not exist in {}", clipper_pattern,
                                 fmt::join(scalars, ", ")));
  }
  return selected;
}

template <std::size_t N>
AnyContestantOf<N> find_contestant(std::string_view clipper, std::string_view scalar) {
  check_scalar(scalar);
  const std::vector<std::string_view> matching = matching_clippers<N>(clipper);
  if (matching.size() > 1) {
    throw UsageError(fmt::format("--clipper: '{}' matches several clippers, name one of: {}",
                                 clipper, fmt::join(matching, ", ")));
  }
  const auto contestant = contestant_named<N>(matching.front(), scalar);
  if (!contestant) {
    throw UsageError(fmt::format("--scalar: {} needs an operation that {} does not have",
                                 matching.front(), scalar));
  }
  return *contestant;
}

template AnyContestantOf<3> find_contestant<3>(std::string_view, std::string_view);

}  // namespace clipscope::experiments
