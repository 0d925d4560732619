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
constexpr std::string_view kPrimitives = N == 1   ? "points"
                                         : N == 2 ? "segments"
                                                  : "triangles";

template <std::size_t N>
std::vector<std::string_view> matching_clippers(std::string_view pattern) {
  std::vector<std::string_view> matching;
  for (const std::string_view name : clipper_names<N>()) {
    if (name == pattern) return {name};
    if (matches(pattern, name)) matching.push_back(name);
  }
  if (matching.empty()) {
    throw UsageError(fmt::format("--clipper: no clipper of {} matches '{}'; there are: {}",
                                 kPrimitives<N>, pattern, fmt::join(clipper_names<N>(), ", ")));
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

template <class T, std::size_t N>
std::string_view scalar_of(const Contestant<T, N>*) {
  return ScalarTraits<T>::name;
}

}  // namespace

template <std::size_t N>
std::string_view scalar_name(const AnyContestantOf<N>& contestant) {
  return std::visit([](const auto* c) { return scalar_of(c); }, contestant);
}

template <std::size_t N>
std::vector<AnyContestantOf<N>> select_contestants(std::string_view clipper_pattern,
                                                   const std::vector<std::string>& scalars) {
  std::vector<AnyContestantOf<N>> selected;
  std::for_each(scalars.begin(), scalars.end(), check_scalar);
  for (const std::string_view clipper : matching_clippers<N>(clipper_pattern)) {
    for (const std::string& scalar : scalars) {
      if (const auto contestant = contestant_named<N>(clipper, scalar)) {
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

template std::string_view scalar_name<1>(const AnyContestantOf<1>&);
template std::string_view scalar_name<2>(const AnyContestantOf<2>&);
template std::string_view scalar_name<3>(const AnyContestantOf<3>&);
template std::vector<AnyContestantOf<1>> select_contestants<1>(std::string_view,
                                                               const std::vector<std::string>&);
template std::vector<AnyContestantOf<2>> select_contestants<2>(std::string_view,
                                                               const std::vector<std::string>&);
template std::vector<AnyContestantOf<3>> select_contestants<3>(std::string_view,
                                                               const std::vector<std::string>&);
template AnyContestantOf<1> find_contestant<1>(std::string_view, std::string_view);
template AnyContestantOf<2> find_contestant<2>(std::string_view, std::string_view);
template AnyContestantOf<3> find_contestant<3>(std::string_view, std::string_view);

}  // namespace clipscope::experiments
