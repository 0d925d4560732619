// SPDX-License-Identifier: MIT
//
// The list of all clippers. To add one: write its header, include it here and add its name to the
// list; everything else (program, experiments, contract tests) follows from that. Where it exists, by
// scalar and input, is what its call operators take (`ClipsViewSpace`, `ClipsClipSpace`).
#pragma once

#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/barycentric/distance_matrix.hpp"
#include "spaces/cvv/cohen_sutherland.hpp"
#include "spaces/cvv/liang_barsky.hpp"
#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/homogeneous/blinn_newell.hpp"
#include "spaces/homogeneous/cohen_sutherland.hpp"
#include "spaces/homogeneous/guard_band.hpp"
#include "spaces/homogeneous/liang_barsky.hpp"
#include "spaces/homogeneous/pipeline.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/homogeneous/textbook.hpp"
#include "spaces/point/points.hpp"
#include "spaces/view/cyrus_beck.hpp"
#include "spaces/view/sutherland_hodgman.hpp"
#include "spaces/whole/drop.hpp"
#include "spaces/window/cohen_sutherland.hpp"
#include "spaces/window/liang_barsky.hpp"
#include "spaces/window/nicholl_lee_nicholl.hpp"

namespace clipscope {

using AllClippers = TypeList<Textbook,                                    //
                             ViewSutherlandHodgman,                       //
                             ViewExactSign,                               //
                             ViewUnitNormals,                             //
                             HomogeneousSutherlandHodgman,                //
                             HomogeneousNearLast,                         //
                             HomogeneousWFirst<WPlane::zero>,             //
                             HomogeneousWFirst<WPlane::smallest_normal>,  //
                             HomogeneousWFirst<WPlane::one_16384th>,      //
                             HomogeneousWFirst<WPlane::one_100000th>,     //
                             HomogeneousPipeline,                         //
                             BlinnNewell,                                 //
                             HomogeneousGuardBand,                        //
                             CvvNaive,                                    //
                             CvvPerspective,                              //
                             CvvNearFirst,                                //
                             DistanceMatrix,                              //
                             CorrectlyRounded,                            //
                             WholeAnyOutside,                             //
                             WholeAllOutside>;

// Clippers of segments: ViewSegment and, where the method starts at clip coordinates, ClipSegment.
using AllSegmentClippers = TypeList<ViewCyrusBeck,                       //
                                    HomogeneousCohenSutherland,          //
                                    HomogeneousLiangBarsky,              //
                                    HomogeneousLiangBarskyDivisionFree,  //
                                    CvvCohenSutherland,                  //
                                    CvvLiangBarsky,                      //
                                    CvvLiangBarskyDivisionFree,          //
                                    CvvLiangBarskyNaive,                 //
                                    WindowCohenSutherland,               //
                                    WindowLiangBarsky,                   //
                                    WindowLiangBarskyDivisionFree,       //
                                    WindowNichollLeeNicholl>;

// Clippers of points, of size 0 unless a PointSize is given.
using AllPointClippers = TypeList<PointPop, PointPopFree>;

}  // namespace clipscope
