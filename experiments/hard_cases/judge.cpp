// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/judge.hpp"

#include <algorithm>

#include "experiments/contestants/contestant.hpp"
#include "experiments/errors.hpp"
#include "experiments/hard_cases/case_input.hpp"
#include "experiments/measure/bit_promise.hpp"
#include "spaces/homogeneous/polygon.hpp"

namespace clipscope::experiments {
namespace {

template <class T>
using Answer = std::vector<NdcVertex<T, kRunTime>>;

template <class T, std::size_t N>
bool takes(const Contestant<T, N>& contestant, const HardCase& hard_case) {
  return is_applicable(contestant.promise, hard_case.volume) &&
         (hard_case.space == Space::view || contestant.clip_one != nullptr);
}

// Pre-condition: takes(contestant, hard_case).
template <class T, std::size_t N>
Answer<T> clip_case(const Contestant<T, N>& contestant, const HardCase& hard_case) {
  NdcPolygon<T, kRunTime> out;
  if (hard_case.space == Space::view) {
    contestant.view_one(case_projection<T>(hard_case), case_simplex<T, Space::view, N>(hard_case),
                        out);
  } else {
    contestant.clip_one(hard_case.volume, case_simplex<T, Space::clip, N>(hard_case), out);
  }
  return {out.begin(), out.end()};
}

template <class T>
Answer<T> clip_polygon_case(const HardCase& hard_case) {
  HomogeneousPolygonClipper<T, kRunTime> clip;
  std::span<const NdcVertex<T, kRunTime>> out;
  if (hard_case.space == Space::view) {
    out = clip(case_projection<T>(hard_case), case_vertices<T, Space::view>(hard_case));
  } else {
    out = clip(hard_case.volume, case_vertices<T, Space::clip>(hard_case));
  }
  return {out.begin(), out.end()};
}

template <class T>
CaseAnswer as_doubles(const Answer<T>& answer) {
  CaseAnswer r;
  for (const NdcVertex<T, kRunTime>& v : answer) {
    std::array<double, 4>& p = r.polygon.emplace_back();
    for (int i = 0; i < 4; ++i) {
      p[static_cast<std::size_t>(i)] = nearest_double(v.position[i]);
    }
  }
  return r;
}

template <class T>
CaseAnswer judged(const Answer<T>& answer, const TruthPolygon& truth) {
  CaseAnswer r = as_doubles(answer);
  r.comparison = compare<T, kRunTime>(std::span<const NdcVertex<T, kRunTime>>(answer), truth);
  return r;
}

CaseAnswer not_applicable() {
  CaseAnswer r;
  r.comparison.outcome = Outcome::not_applicable;
  return r;
}

template <class T>
PromiseCheck check_promise(const Contestant<T>& contestant, const HardCase& hard_case) {
  const PromiseChecker checker = hard_case.space == Space::view
                                     ? PromiseChecker(hard_case.frustum, hard_case.volume)
                                     : PromiseChecker(hard_case.volume);
  const Answer<T> answer = clip_case(contestant, hard_case);
  PromiseCheck check = checker.check<T, kRunTime>(contestant.promise, triangle_of(hard_case),
                                                  std::span<const NdcVertex<T, kRunTime>>(answer));
  const std::string broken = hard_case.space == Space::view
                                 ? broken_bits<T>(contestant, hard_case.frustum, hard_case.volume,
                                                  case_simplex<T, Space::view, 3>(hard_case))
                                 : broken_bits<T>(contestant, hard_case.volume,
                                                  case_simplex<T, Space::clip, 3>(hard_case));
  break_by_bits(check, broken);
  return check;
}

template <class T, std::size_t N>
CaseContestant case_contestant(const Contestant<T, N>& c) {
  CaseContestant r{std::string(c.name), std::string(ScalarTraits<T>::name), {}, {}, {}};
  r.answer = [&c](const HardCase& hard_case, const TruthPolygon& truth) {
    return takes(c, hard_case) ? judged(clip_case(c, hard_case), truth) : not_applicable();
  };
  r.polygon_of = [&c](const HardCase& hard_case) {
    return takes(c, hard_case) ? as_doubles(clip_case(c, hard_case)) : not_applicable();
  };
  if constexpr (N == 3) {
    r.keeps_promise = [&c](const HardCase& hard_case) {
      if (!takes(c, hard_case)) return PromiseCheck{PromiseVerdict::outside_domain, 0, ""};
      return check_promise(c, hard_case);
    };
  }
  return r;
}

// The clippers of this primitive that match, if any does.
template <std::size_t N>
std::vector<CaseContestant> simplex_contestants(std::string_view pattern,
                                                const std::vector<std::string>& scalars) {
  std::vector<CaseContestant> r;
  try {
    for (const AnyContestantOf<N>& any : select_contestants<N>(pattern, scalars)) {
      r.push_back(std::visit([](const auto* c) { return case_contestant(*c); }, any));
    }
  } catch (const UsageError&) {
    // The pattern names clippers of another primitive; what is wrong altogether was found before.
  }
  return r;
}

std::vector<CaseContestant> polygon_contestants(const std::vector<std::string>& scalars) {
  std::vector<CaseContestant> r;
  for (const std::string& scalar : scalars) {
    for_each_type(AllScalars{}, [&]<class T>() {
      if (ScalarTraits<T>::name != scalar) return;
      r.push_back(
          {"homogeneous/polygon",
           scalar,
           [](const HardCase& hard_case, const TruthPolygon& truth) {
             return judged(clip_polygon_case<T>(hard_case), truth);
           },
           [](const HardCase& hard_case) { return as_doubles(clip_polygon_case<T>(hard_case)); },
           {}});
    });
  }
  return r;
}

}  // namespace

std::vector<CaseContestant> case_contestants(Primitive primitive, std::string_view clipper_pattern,
                                             const std::vector<std::string>& scalars) {
  switch (primitive) {
    case Primitive::point: return simplex_contestants<1>(clipper_pattern, scalars);
    case Primitive::segment: return simplex_contestants<2>(clipper_pattern, scalars);
    case Primitive::triangle: return simplex_contestants<3>(clipper_pattern, scalars);
    case Primitive::polygon: break;
  }
  return polygon_contestants(scalars);
}

TruthPolygon truth_polygon(const HardCase& hard_case) {
  return truth_polygon(truth_of(hard_case), hard_case.vertices, hard_case.attribute_count);
}

}  // namespace clipscope::experiments
