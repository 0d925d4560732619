// SPDX-License-Identifier: GPL-3.0-or-later
//
// What clippers of others leave: a plug-in in the memory that it shares, a program in the text that
// it writes. Each primitive gets a polygon or a reason why it has none.
#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

#include "experiments/guests/plugin_said.hpp"
#include "experiments/guests/program_text.hpp"
#include "experiments/table/utf8.hpp"
#include "tests/fuzz/harness.hpp"

namespace clipscope::fuzz {
namespace {

using namespace experiments;

void require_text(const std::string& text) {
  require(valid_utf8(text) == text, "a text is no UTF-8");
}

void require_reason(const Failure& failure) {
  require(!failure.reason.empty(), "a failure has no reason");
  require_text(failure.reason);
}

// Whatever a control area holds.
void read_control(Bytes bytes) {
  const auto said = std::make_unique<plugin::Control>();
  std::memcpy(static_cast<void*>(said.get()), bytes.data(), std::min(sizeof *said, bytes.size()));
  if (const auto failure = malformed(*said)) require_reason(*failure);
  for (const int status : {0, 11, 0x100, 0x7f, 0xffff}) {
    require_reason(failure_of_end(*said, status));
  }
  require_text(experiments::text_of(said->text));
  const plugin::Description& d = said->description;
  for (const plugin::Text& text : {d.name, d.summary, d.source}) {
    require_text(experiments::text_of(text));
  }
}

template <class T>
void read_output(ByteReader in, const Format& format) {
  const auto count = static_cast<std::size_t>(in.below(6)),
             most = static_cast<std::size_t>(in.below(12)),
             stride = static_cast<std::size_t>(4 + in.below(5));
  std::vector<std::size_t> ends;
  for (std::size_t i = 0; i < count; ++i) {
    const int kind = in.below(4);
    ends.push_back(kind == 0 ? in.take<std::uint64_t>() : in.take<std::uint8_t>() % 64u);
  }
  // As long as it must be and no longer, so that what lies beyond is another's.
  const auto numbers = std::make_unique<T[]>(count * most * stride);
  for (std::size_t i = 0; i < count * most * stride; ++i) numbers[i] = in.take<T>();
  Answers answers(format, stride);
  read_polygons<T>({numbers.get(), ends.data(), count, most, stride}, answers);
  require(answers.size() == count, "{} primitives have {} answers", count, answers.size());
  for (std::size_t i = 0; i < count; ++i) {
    require(answers[i].size() <= most, "a polygon has {} vertices, {} at most asked for",
            answers[i].size(), most);
    if (const Failure* failure = answers[i].failure()) require_reason(*failure);
  }
}

}  // namespace

void plugin(Bytes bytes) {
  ByteReader in(bytes);
  switch (in.below(3)) {
    case 0: return read_output<float>(in, kFormat<float>);
    case 1: return read_output<double>(in, kFormat<double>);
    default: return read_control(in.rest());
  }
}

void program(Bytes bytes) {
  ByteReader in(bytes);
  ProgramForm form;
  form.primitive = static_cast<Primitive>(in.below(4));
  form.format = in.below(2) == 0 ? &kFormat<float> : &kFormat<double>;
  const auto count = static_cast<std::size_t>(in.below(8));
  const int attributes = in.below(4);
  const WrittenAnswers written = read_answers(text_of(in.rest()), count, attributes, form);
  require_text(written.wrong);
  require(written.polygons.size() == count, "{} primitives have {} answers", count,
          written.polygons.size());
  for (const WrittenPolygon& polygon : written.polygons) {
    require_text(polygon.wrong);
    const auto stride = static_cast<std::size_t>(4 + attributes);
    require(!polygon.wrong.empty() || polygon.numbers.size() % stride == 0,
            "a polygon has {} numbers, {} per vertex", polygon.numbers.size(), stride);
    for (const double x : polygon.numbers) {
      require(!form.format->is_float() || std::isnan(x) || double{static_cast<float>(x)} == x,
              "{} was not rounded to float", x);
      for (const bool hex : {false, true}) {
        ProgramForm again = form;
        again.hex = hex;
        const std::string text = number_text(x, again);
        const double read = form.format->is_float() ? std::strtof(text.c_str(), nullptr)
                                                    : std::strtod(text.c_str(), nullptr);
        require((std::isnan(x) && std::isnan(read)) || read == x, "{} is written as '{}'", x, text);
      }
    }
  }
}

}  // namespace clipscope::fuzz
