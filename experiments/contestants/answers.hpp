// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a contestant answers, in whatever scalar it computes: one polygon, maybe empty, for each
// primitive, and every number as it is, to the bit.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "experiments/contestants/scalars.hpp"

namespace clipscope::experiments {

// A number of an answer. NaN and infinity are those of `value`.
struct Number {
  double value = 0;                              // itself; of wider scalars the nearest double
  double rest = 0;                               // double-double: the number is value + rest
  std::shared_ptr<const Exact> exact = nullptr;  // exact arithmetic: the number

  // Compares values: 0 equals -0, and a NaN equals nothing.
  friend bool operator==(const Number& a, const Number& b) {
    if (a.exact && b.exact) return *a.exact == *b.exact;
    return a.value == b.value && a.rest == b.rest;
  }
};

inline double nearest_double(const Number& x) { return x.value; }
inline bool is_finite(const Number& x) { return std::isfinite(x.value); }
inline bool is_nan(const Number& x) { return std::isnan(x.value); }
// Pre-condition: is_finite(x).
Exact to_exact(const Number& x);

// a - b and a b as the scalar computes them.
Number difference(const Format& format, const Number& a, const Number& b);
Number product(const Format& format, const Number& a, const Number& b);
// x 2^exponent, exactly but for overflow and underflow.
Number times_power_of_two(const Number& x, int exponent);

class Answers;

// Why there is no answer to a primitive: what can become of a guest (guests/guest.hpp) that none of
// our own clippers does.
struct Failure {
  enum class Kind {
    crashed,    // its process ended, also by reaching out of its buffers
    timed_out,  // it did not end in time
    malformed   // what it left is no answer: too many vertices, say, or an error
  };
  Kind kind = Kind::crashed;
  std::string reason;  // a sentence without its full stop
};

// A vertex of a polygon: x y z 1/w, then the attributes. Before the divide x y z w, in view space
// x y z 1.
class VertexView {
 public:
  VertexView(const Answers& answers, std::size_t vertex) : answers_(&answers), vertex_(vertex) {}

  std::size_t index() const { return vertex_; }  // among all vertices of the answers
  std::size_t size() const;                      // numbers
  Number operator[](std::size_t i) const;
  Number position(int i) const { return (*this)[static_cast<std::size_t>(i)]; }
  Number attribute(int k) const { return (*this)[static_cast<std::size_t>(4 + k)]; }

 private:
  const Answers* answers_;
  std::size_t vertex_;
};

// A polygon of the answers, as long as these live.
class PolygonView {
 public:
  PolygonView(const Answers& answers, std::size_t primitive, std::size_t first, std::size_t size)
      : answers_(&answers), primitive_(primitive), first_(first), size_(size) {}

  std::size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }
  VertexView operator[](std::size_t i) const { return {*answers_, first_ + i}; }
  const Format& format() const;
  // Why there is no answer, whose polygon then is empty; null where there is one.
  const Failure* failure() const;

  struct Iterator {
    using value_type = VertexView;
    using difference_type = std::ptrdiff_t;

    const Answers* answers = nullptr;
    std::size_t at = 0;

    VertexView operator*() const { return {*answers, at}; }
    Iterator& operator++() {
      ++at;
      return *this;
    }
    Iterator operator++(int) { return {answers, at++}; }
    friend bool operator==(const Iterator&, const Iterator&) = default;
  };
  Iterator begin() const { return {answers_, first_}; }
  Iterator end() const { return {answers_, first_ + size_}; }

 private:
  const Answers* answers_;
  std::size_t primitive_, first_, size_;
};

class Answers {
 public:
  Answers(const Format& format, std::size_t numbers_per_vertex)
      : format_(&format), stride_(numbers_per_vertex) {}

  const Format& format() const { return *format_; }
  std::size_t stride() const { return stride_; }     // numbers per vertex
  std::size_t size() const { return ends_.size(); }  // polygons
  PolygonView operator[](std::size_t i) const {
    const std::size_t first = i == 0 ? 0 : ends_[i - 1];
    return {*this, i, first, ends_[i] - first};
  }
  // To be filled number by number, then `end_polygon` after the last of a polygon.
  void add(float x) { values_.push_back(x); }
  void add(double x) { values_.push_back(x); }
  void add(const Counted& x) { values_.push_back(x.value()); }
  void add(const dd_real& x);
  void add(const Exact& x);
  void end_polygon() { ends_.push_back(values_.size() / stride_); }
  // There is no answer to the primitive; it gets an empty polygon.
  void fail(Failure failure) {
    failures_.emplace(ends_.size(), std::move(failure));
    end_polygon();
  }

  // Whether the polygon was given by its number: it is the primitive itself.
  bool is_listed(std::size_t i) const { return std::ranges::binary_search(listed, i); }

  std::vector<std::size_t> listed;  // ascending
  bool overflowed = false;          // some polygon had more vertices than a clipper has room for

 private:
  friend class VertexView;
  friend class PolygonView;

  const Format* format_;
  std::size_t stride_;
  std::vector<double> values_, rests_;
  std::vector<Exact> exact_;
  std::vector<std::size_t> ends_;  // polygon i has the vertices [ends[i - 1], ends[i])
  std::map<std::size_t, Failure> failures_;
};

// A typed polygon, vertex by vertex. Vertices: a list or a span of them.
template <class Vertices>
void add_polygon(const Vertices& vertices, Answers& answers) {
  for (const auto& v : vertices) {
    for (int i = 0; i < v.kDimension; ++i) answers.add(v.position[i]);
    if (v.kDimension == 3) answers.add(1.0);
    for (int k = 0; k < v.attributes.size(); ++k) answers.add(v.attributes[k]);
  }
  answers.end_polygon();
}

}  // namespace clipscope::experiments
