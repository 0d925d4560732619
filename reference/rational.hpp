// SPDX-License-Identifier: GPL-3.0-or-later
//
// Canonical rational numbers: GMP's mpq_class, without CGAL's number traits (fraction.hpp). What
// includes this alone is compiled without the flags that CGAL asks for.
#pragma once

#include <gmpxx.h>

namespace clipscope::reference {

using Rational = mpq_class;

}  // namespace clipscope::reference
