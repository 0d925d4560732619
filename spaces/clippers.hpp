// SPDX-License-Identifier: MIT
//
// The list of all clippers. To add one: write its header, include it here and add its name to the
// list, with the spaces that it takes; everything else (program, experiments, contract tests)
// follows from that. In which scalars it exists is what its call operators take.
#pragma once

#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/barycentric/distance_matrix.hpp"
#include "spaces/cvv/cohen_sutherland.hpp"
#include "spaces/cvv/liang_barsky.hpp"
#include "spaces/cvv/skala_polyhedron.hpp"
#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/homogeneous/blinn.hpp"
#include "spaces/homogeneous/blinn_newell.hpp"
#include "spaces/homogeneous/cohen_sutherland.hpp"
#include "spaces/homogeneous/cyrus_beck.hpp"
#include "spaces/homogeneous/guard_band.hpp"
#include "spaces/homogeneous/interpolation.hpp"
#include "spaces/homogeneous/liang_barsky.hpp"
#include "spaces/homogeneous/mcguire.hpp"
#include "spaces/homogeneous/opposite_planes.hpp"
#include "spaces/homogeneous/pipeline.hpp"
#include "spaces/homogeneous/pruning.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/homogeneous/textbook.hpp"
#include "spaces/point/points.hpp"
#include "spaces/view/cyrus_beck.hpp"
#include "spaces/view/sutherland_hodgman.hpp"
#include "spaces/whole/drop.hpp"
#include "spaces/window/cohen_sutherland.hpp"
#include "spaces/window/cyrus_beck.hpp"
#include "spaces/window/kodituwakku_wijeweera_chamikara.hpp"
#include "spaces/window/liang_barsky.hpp"
#include "spaces/window/liang_barsky_polygon.hpp"
#include "spaces/window/maillot.hpp"
#include "spaces/window/matthes_drakopoulos.hpp"
#include "spaces/window/midpoint_subdivision.hpp"
#include "spaces/window/nicholl_lee_nicholl.hpp"
#include "spaces/window/ray.hpp"
#include "spaces/window/skala.hpp"
#include "spaces/window/sobkow_pospisil_yang.hpp"

namespace clipscope {

using AllClippers = TriangleClippers<ViewAndClip<Textbook>,                                    //
                                     ViewOnly<ViewSutherlandHodgman>,                          //
                                     ViewOnly<ViewExactSign>,                                  //
                                     ViewOnly<ViewUnitNormals>,                                //
                                     ViewAndClip<HomogeneousSutherlandHodgman>,                //
                                     ViewAndClip<HomogeneousNearLast>,                         //
                                     ViewAndClip<HomogeneousWFirst<WPlane::zero>>,             //
                                     ViewAndClip<HomogeneousWFirst<WPlane::smallest_normal>>,  //
                                     ViewAndClip<HomogeneousWFirst<WPlane::one_16384th>>,      //
                                     ViewAndClip<HomogeneousWFirst<WPlane::one_100000th>>,     //
                                     ViewAndClip<HomogeneousPipeline>,                         //
                                     ViewAndClip<BlinnNewell>,                                 //
                                     ViewAndClip<HomogeneousGuardBand>,                        //
                                     ViewAndClip<HomogeneousMcGuire>,                          //
                                     ViewAndClip<HomogeneousFromInside>,                       //
                                     ViewAndClip<HomogeneousFromOutside>,                      //
                                     ViewAndClip<HomogeneousWeightedEnds>,                     //
                                     ViewAndClip<HomogeneousOppositePlanes>,                   //
                                     ViewAndClip<CvvNaive>,                                    //
                                     ViewAndClip<CvvPerspective>,                              //
                                     ViewAndClip<CvvNearFirst>,                                //
                                     ViewAndClip<WindowLiangBarskyPolygon>,                    //
                                     ViewAndClip<WindowMaillot>,                               //
                                     ViewAndClip<DistanceMatrix>,                              //
                                     ViewAndClip<CorrectlyRounded>,                            //
                                     ViewAndClip<WholeAnyOutside>,                             //
                                     ViewAndClip<WholeAllOutside>>;

// Clippers of segments.
using AllSegmentClippers = SegmentClippers<ViewOnly<ViewCyrusBeck>,                           //
                                           ViewOnly<ViewCyrusBeckUnitNormals>,                //
                                           ViewAndClip<HomogeneousCyrusBeck>,                 //
                                           ViewAndClip<HomogeneousBlinn>,                     //
                                           ViewAndClip<HomogeneousPruning>,                   //
                                           ViewAndClip<HomogeneousCohenSutherland>,           //
                                           ViewAndClip<HomogeneousLiangBarsky>,               //
                                           ViewAndClip<HomogeneousLiangBarskyDivisionFree>,   //
                                           ViewAndClip<CvvCohenSutherland>,                   //
                                           ViewAndClip<CvvLiangBarsky>,                       //
                                           ViewAndClip<CvvLiangBarskyDivisionFree>,           //
                                           ViewAndClip<CvvLiangBarskyNaive>,                  //
                                           ViewAndClip<CvvSkalaPolyhedron>,                   //
                                           ViewAndClip<WindowCohenSutherland>,                //
                                           ViewAndClip<WindowCyrusBeck>,                      //
                                           ViewAndClip<WindowLiangBarsky>,                    //
                                           ViewAndClip<WindowLiangBarskyDivisionFree>,        //
                                           ViewAndClip<WindowNichollLeeNicholl>,              //
                                           ViewAndClip<WindowMidpointSubdivision>,            //
                                           ViewAndClip<WindowSobkowPospisilYang>,             //
                                           ViewAndClip<WindowSkala>,                          //
                                           ViewAndClip<WindowRay>,                            //
                                           ViewAndClip<WindowKodituwakkuWijeweeraChamikara>,  //
                                           ViewAndClip<WindowMatthesDrakopoulos>>;

// Clippers of points, of size 0 unless a PointSize is given.
using AllPointClippers = PointClippers<ViewAndClip<PointPop>, ViewAndClip<PointPopFree>>;

}  // namespace clipscope
