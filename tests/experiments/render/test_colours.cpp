// SPDX-License-Identifier: GPL-3.0-or-later
//
// What heat_map.hpp claims about its colours, with simulated colour vision deficiencies: Machado,
// Oliveira and Fernandes, "A Physiologically-based Model for Simulation of Color Vision
// Deficiency", 2009, table 1, severity 1.0, applied in linear light.
#include <algorithm>
#include <array>
#include <cmath>

#include "experiments/render/heat_map.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

using Row = std::array<double, 3>;
using Matrix = std::array<Row, 3>;

constexpr std::array<Matrix, 4> kVisions = {{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                             {{{0.152286, 1.052583, -0.204868},
                                               {0.114503, 0.786281, 0.099216},
                                               {-0.003882, -0.048116, 1.051998}}},
                                             {{{0.367322, 0.860646, -0.227968},
                                               {0.280085, 0.672501, 0.047413},
                                               {-0.011820, 0.042940, 0.968881}}},
                                             {{{1.255528, -0.076749, -0.178779},
                                               {-0.078411, 0.930809, 0.147602},
                                               {0.004733, 0.691367, 0.303900}}}}};

// Linear Rec. 709 to XYZ, each row divided by the D65 white.
constexpr Matrix kToXyz = {{{0.433953, 0.376219, 0.189828},
                            {0.212671, 0.715160, 0.072169},
                            {0.017758, 0.109477, 0.872765}}};

Row times(const Matrix& m, const Row& v) {
  Row r;
  for (std::size_t i = 0; i < 3; ++i) {
    r[i] = std::clamp(m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2], 0.0, 1.0);
  }
  return r;
}

Row lab(const Rgb& colour, const Matrix& vision) {
  const Row linear = {colour[0], colour[1], colour[2]};
  Row f = times(kToXyz, times(vision, linear));
  for (double& c : f) c = c > 216.0 / 24389 ? std::cbrt(c) : (24389.0 / 27 * c + 16) / 116;
  return {116 * f[1] - 16, 500 * (f[0] - f[1]), 200 * (f[1] - f[2])};
}

double difference(const Rgb& a, const Rgb& b, const Matrix& vision) {
  const Row p = lab(a, vision), q = lab(b, vision);
  return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

constexpr std::array<PixelFate, 4> kSignals = {PixelFate::hole, PixelFate::extra,
                                               PixelFate::flipped, PixelFate::not_finite};

TEST_CASE("colours: signals differ from every error and from the ground in every colour vision") {
  for (const Matrix& vision : kVisions) {
    for (const PixelFate signal : kSignals) {
      const Rgb colour = fate_colour(signal);
      CHECK(difference(colour, fate_colour(PixelFate::empty), vision) >= 24);
      CHECK(difference(colour, fate_colour(PixelFate::equal), vision) >= 24);
      for (int i = 0; i <= 100; ++i) {
        CHECK(difference(colour, error_colour(i / 100.0), vision) >= 24);
      }
    }
  }
}

TEST_CASE("colours: lightness grows with the error in every colour vision") {
  for (const Matrix& vision : kVisions) {
    for (int i = 1; i <= 100; ++i) {
      INFO("step " << i << " of 100");
      CHECK(lab(error_colour((i - 1) / 100.0), vision)[0] <
            lab(error_colour(i / 100.0), vision)[0]);
    }
  }
}

TEST_CASE("colours: an error beyond the scale, or none, takes the colour of the nearer end") {
  CHECK(error_colour(-3) == error_colour(0));
  CHECK(error_colour(7) == error_colour(1));
  CHECK(error_colour(std::nan("")) == error_colour(0));
}

}  // namespace
}  // namespace clipscope::experiments
