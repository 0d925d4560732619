// SPDX-License-Identifier: MIT
//
// The list of all clippers. To add one: write its header, include it here and add its name to the
// list; everything else (program, experiments, contract tests) follows from that.
#pragma once

#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/homogeneous/textbook.hpp"
#include "spaces/view/sutherland_hodgman.hpp"
#include "spaces/whole/drop.hpp"

namespace clipscope {

using AllClippers = TypeList<Textbook,                      //
                             ViewSutherlandHodgman,         //
                             HomogeneousSutherlandHodgman,  //
                             CvvNaive,                      //
                             CvvPerspective,                //
                             CvvNearFirst,                  //
                             WholeAnyOutside,               //
                             WholeAllOutside>;

}  // namespace clipscope
