// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/program_text.hpp"

#include <cmath>
#include <cstdlib>
#include <limits>

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

constexpr ProgramForm kFloats{.format = &kFormat<float>};
constexpr ProgramForm kDoubles{.format = &kFormat<double>};

TEST_CASE("program text: numbers read back as they are, in decimal and in hex") {
  for (const float x : {0.1f, -0.0f, 1e-45f, 0x1.fffffep127f, 16777216.0f, -3.5f}) {
    for (const bool hex : {false, true}) {
      const ProgramForm form{.format = &kFormat<float>, .hex = hex};
      const float back = std::strtof(number_text(x, form).c_str(), nullptr);
      CHECK(back == x);
      CHECK(std::signbit(back) == std::signbit(x));
    }
  }
  CHECK(number_text(0.1f, kFloats) == "0.1");
  CHECK(number_text(0.1, kDoubles) == "0.1");
  CHECK(number_text(0.1f, {.format = &kFormat<float>, .hex = true}) == "0x1.99999ap-4");
}

TEST_CASE("program text: a primitive is a line, of a polygon as long as it has vertices") {
  const GuestInput input{
      .space = Space::view, .volume = {}, .attributes = 1, .numbers = {}, .ends = {3, 7}};
  GuestInput filled = input;
  for (int i = 0; i < 28; ++i) filled.numbers.push_back(i);
  CHECK(lines_of(filled, {0, 1}, kFloats) == "0 1 2 3 4 5 6 7 8 9 10 11\n");
  CHECK(lines_of(filled, {1, 1}, kFloats) == "12 13 14 15 16 17 18 19 20 21 22 23 24 25 26 27\n");
}

TEST_CASE("program text: headings, blank lines, blanks and the order of triangles do not matter") {
  const std::string rows = "1,0,0.1,0,0,1\r\n0,0,-0x1p-1, inf,nan ,1\n\n1,1,1,2,3,4\n";
  for (const char* headings : {"", "triangle,vertex,x,y,z,inv_w\n"}) {
    const WrittenAnswers a = read_answers(headings + rows, 3, 0, kFloats);
    CHECK(a.wrong.empty());
    REQUIRE(a.polygons.size() == 3);
    for (const WrittenPolygon& polygon : a.polygons) CHECK(polygon.wrong.empty());
    CHECK(a.polygons[0].numbers[0] == -0.5);
    CHECK(std::isinf(a.polygons[0].numbers[1]));
    CHECK(std::isnan(a.polygons[0].numbers[2]));
    CHECK(a.polygons[1].numbers == std::vector<double>{0.1f, 0, 0, 1, 1, 2, 3, 4});
    CHECK(a.polygons[2].numbers.empty());
  }
}

TEST_CASE("program text: a number is rounded once, to the scalar") {
  // Half an ulp above 1 and a little: rounded to double first, it would be a tie.
  const std::string row = "0,0,1.000000059604644775390625000000001,0,0,1\n";
  CHECK(read_answers(row, 1, 0, kFloats).polygons[0].numbers[0] == 0x1.000002p+0);
  CHECK(read_answers(row, 1, 0, kDoubles).polygons[0].numbers[0] == 0x1.000001p+0);
}

TEST_CASE("program text: what is no answer is named, with its line") {
  const auto wrong = [](const std::string& csv) {
    const WrittenAnswers a = read_answers(csv, 2, 0, kFloats);
    CHECK(a.polygons[1].wrong.empty());
    return a.wrong + a.polygons[0].wrong;
  };
  CHECK_THAT(wrong("0,0,1,2,3,4\nhello\n"),
             Catch::Contains("writes 'hello' in line 2: expected a row of triangle,vertex"));
  CHECK_THAT(wrong("2,0,1,2,3,4\n"),
             Catch::Contains("there is no triangle 2; it was asked about 2"));
  CHECK_THAT(wrong("0,1,1,2,3,4\n"), Catch::Contains("vertex '1' is out of order, expected 0"));
  CHECK_THAT(wrong("0,0,1,2,3,4\n0,0,1,2,3,4\n"), Catch::Contains("out of order, expected 1"));
  CHECK_THAT(wrong("0,0,1,2,3\n"), Catch::Contains("5 columns, expected 6"));
  CHECK_THAT(wrong("0,0,1,2,3,x\n"), Catch::Contains("'x' is not a number"));
  CHECK_THAT(wrong("-1,0,1,2,3,4\n"), Catch::Contains("expected a row of"));
  CHECK_THAT(wrong("triangle,vertex,x,y,z\n"), Catch::Contains("line 1"));
}

TEST_CASE("program text: a polygon has one part") {
  const ProgramForm form{.primitive = Primitive::polygon, .format = &kFormat<float>};
  const WrittenAnswers a = read_answers(
      "polygon,part,vertex,x,y,z,inv_w,a0\n0,0,0,1,2,3,4,5\n1,1,0,1,2,3,4,5\n", 2, 1, form);
  CHECK(a.polygons[0].numbers.size() == 5);
  CHECK_THAT(a.polygons[1].wrong, Catch::Contains("expected part 0"));
}

}  // namespace
}  // namespace clipscope::experiments
