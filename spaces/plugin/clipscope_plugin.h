/* SPDX-License-Identifier: MIT
 *
 * A clipper of yours as a plug-in of clipscope: the whole interface, in C99 (and C++).
 *
 * Copy this file, write one function that clips a batch of primitives, describe it in a
 * `clipscope_plugin` and export `clipscope_plugin_entry`:
 *
 *     cc -std=c99 -O2 -shared -fPIC -o libmine.so mine.c
 *     clipscope verify --plugin ./libmine.so
 *
 * The plug-in is loaded by a process of its own, which loads nothing else: it may crash or loop for
 * ever. It reads its input from memory that it can't write, and writes its answer to memory that
 * ends where the answer may end.
 *
 * The contract is that of all clippers of clipscope (spaces/README.md): of each primitive the part
 * inside the closed clip volume, as one convex polygon.
 *
 *   spaces      view: (x, y, z), right-handed, the eye at the origin, looking down -z.
 *               clip: (x, y, z, w), before the divide; w = -z_view in perspective, 1 without.
 *               The answer is in NDC: (x, y, z, 1/w), or in clip space, see
 *               CLIPSCOPE_ANSWERS_IN_CLIP_SPACE.
 *   volume      -w <= x <= w, -w <= y <= w, and depth as the task says. A point on a plane is
 *               inside. x = y = z = w = 0 is outside.
 *   winding     that of the primitive; from any vertex on. A segment's ends keep their order.
 *   vertices    of a triangle's polygon none, or 3 to 9, one more for each clip distance; of a
 *               segment none or 2; of a point none or 1. A polygon of n vertices behaves as a
 *               triangle does, with n in place of 3.
 *   attributes  numbers per vertex, true values at that point (never divided by w), linear over the
 *               primitive in view space and in clip space. The first `clip_distances` of them are
 *               clip distances: what is negative is outside. The answer has all attributes, clip
 *               distances too.
 *   NaN, inf    a primitive with a position coordinate that is not finite yields nothing.
 *   units       NDC and clip coordinates have none; view space has that of the caller. Sizes are
 *               counted in elements (numbers, vertices, primitives), never in bytes.
 */
#ifndef CLIPSCOPE_PLUGIN_H
#define CLIPSCOPE_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this interface. A host that speaks another one does not ask the plug-in. */
#define CLIPSCOPE_PLUGIN_ABI 1u

#define CLIPSCOPE_MOST_ATTRIBUTES 32u

/* Capabilities: what the plug-in can be asked. It is asked nothing else. At least one scalar, one
 * space, one primitive and one depth convention. Those of the first four groups name what a task is
 * about, too. */
enum {
  /* Scalars. */
  CLIPSCOPE_FLOAT = 1 << 0, /* IEEE binary32 */
  CLIPSCOPE_DOUBLE = 1 << 1,

  /* Spaces of the input. Who takes clip space alone is asked about view space all the same: the
   * host projects then, in the plug-in's scalar, and the time of that is the plug-in's. */
  CLIPSCOPE_VIEW_SPACE = 1 << 2,
  CLIPSCOPE_CLIP_SPACE = 1 << 3,

  /* Primitives. */
  CLIPSCOPE_POINTS = 1 << 4,
  CLIPSCOPE_SEGMENTS = 1 << 5,
  CLIPSCOPE_TRIANGLES = 1 << 6,
  CLIPSCOPE_POLYGONS = 1 << 7, /* convex and flat, of 3 vertices or more */

  /* Depth conventions: the range of z/w from near to far. */
  CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE = 1 << 8, /* OpenGL: -w <= z <= w, near at -1 */
  CLIPSCOPE_DEPTH_ZERO_TO_ONE = 1 << 9,      /* Direct3D, Vulkan: 0 <= z <= w, near at 0 */
  CLIPSCOPE_DEPTH_REVERSED = 1 << 10,        /* 0 <= z <= w, near at 1 */

  /* Frusta that are clipped against in view space, beside perspective ones with left = -right,
   * bottom = -top and a finite far plane. Who takes clip space, too, is asked about others there,
   * and about any matrix. */
  CLIPSCOPE_OFF_CENTRE = 1 << 11,
  CLIPSCOPE_INFINITE_FAR = 1 << 12,
  CLIPSCOPE_ORTHOGRAPHIC = 1 << 13,
  CLIPSCOPE_OBLIQUE = 1 << 14, /* orthographic after a shear */

  /* Options of the volume. */
  CLIPSCOPE_DEPTH_CLAMP = 1 << 15,    /* near or far, or both, may not clip */
  CLIPSCOPE_CLIP_DISTANCES = 1 << 16, /* up to 8 */
  CLIPSCOPE_OPEN_SIDES = 1 << 17,     /* a side may not own its points: spaces/volume.hpp */

  /* The answer is in clip space: (x, y, z, w) in place of (x, y, z, 1/w). The host divides, and the
   * time of that is the plug-in's. Takes CLIPSCOPE_CLIP_SPACE without CLIPSCOPE_VIEW_SPACE. */
  CLIPSCOPE_ANSWERS_IN_CLIP_SPACE = 1 << 18,

  /* Several threads of a process may call the plug-in at once. Else one does. */
  CLIPSCOPE_THREAD_SAFE = 1 << 19
};

/* Bits of `depth_clamp`: that plane does not clip, and depths beyond its range remain. */
enum { CLIPSCOPE_CLAMP_NEAR = 1, CLIPSCOPE_CLAMP_FAR = 2 };

/* Bits of `open_sides`: that side does not own its points. */
enum {
  CLIPSCOPE_OPEN_LEFT = 1,
  CLIPSCOPE_OPEN_RIGHT = 2,
  CLIPSCOPE_OPEN_BOTTOM = 4,
  CLIPSCOPE_OPEN_TOP = 8
};

/* The view volume of a task in view space. Perspective: left, right, bottom and top are measured on
 * the near plane. Orthographic: they bound x + shear_x z and y + shear_y z. Points of the volume
 * have -z_far <= z <= -z_near. All numbers are values of the task's scalar. */
typedef struct clipscope_frustum {
  double left, right, bottom, top, z_near, z_far;
  double shear_x, shear_y;  /* 0 unless oblique */
  uint32_t is_orthographic; /* 0 or 1 */
  uint32_t is_infinite;     /* 0 or 1: there is no far plane, and z_far is 0 */
} clipscope_frustum;

/* What is asked: `count` primitives, all clipped against the same volume. Everything here can be
 * read as long as the call lasts, and nothing can be written. */
typedef struct clipscope_task {
  uint32_t struct_size;    /* sizeof(clipscope_task) of the host: fields may join at the end */
  uint32_t scalar;         /* CLIPSCOPE_FLOAT or CLIPSCOPE_DOUBLE */
  uint32_t space;          /* CLIPSCOPE_VIEW_SPACE or CLIPSCOPE_CLIP_SPACE */
  uint32_t primitive;      /* CLIPSCOPE_POINTS to CLIPSCOPE_POLYGONS */
  uint32_t depth;          /* CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE to CLIPSCOPE_DEPTH_REVERSED */
  uint32_t depth_clamp;    /* bits */
  uint32_t open_sides;     /* bits */
  uint32_t clip_distances; /* 0 to 8: so many of the first attributes */
  uint32_t attributes;     /* 0 to most_attributes of the plug-in, per vertex */
  uint32_t stride;         /* numbers per vertex: 3 (view) or 4 (clip), and attributes */

  size_t count;    /* primitives */
  size_t vertices; /* of all of them */
  /* Of polygons: primitive i has the vertices [ends[i - 1], ends[i]), the first from 0 on. Of other
   * primitives null: each has 1, 2 or 3. */
  const size_t* ends;
  /* vertices * stride numbers, vertex after vertex: position, then attributes. The pointer of the
   * task's scalar; the other one is null. */
  const float* floats;
  const double* doubles;

  /* Of view space; of clip space all 0. The matrix leads to clip space, by rows; its entries are
   * computed in the task's scalar (spaces/projection.hpp). */
  clipscope_frustum frustum;
  double matrix[16];
  double point_half_size[2]; /* of points: half the width and height of their square, in NDC */
} clipscope_task;

/* Where the answer goes. The arrays are aligned as their elements are, no further, and hold what
 * was there before: what is not written is not 0. All of them may be written and read up to their
 * size, also beyond what the answer then takes; memory beyond that is not accessible. */
typedef struct clipscope_answer {
  uint32_t struct_size; /* sizeof(clipscope_answer) of the host */
  uint32_t stride;      /* numbers per vertex: 4 and attributes */
  size_t capacity;      /* vertices that there is room for: most_vertices for each primitive */
  /* Of one polygon: as many as an exact answer may have, and one more for a plane of the plug-in's
   * own. Of primitives of different sizes: of the largest one. */
  size_t most_vertices;
  /* capacity * stride numbers, polygon after polygon, of each vertex x, y, z, 1/w (or w), then
   * attributes. The pointer of the task's scalar; the other one is null. */
  float* floats;
  double* doubles;
  size_t* ends; /* task->count: after primitive i there are ends[i] vertices in all, from 0 on */
} clipscope_answer;

/* What `clip` returns. */
enum {
  CLIPSCOPE_DONE = 0,  /* an answer to every primitive */
  CLIPSCOPE_FAILED = 1 /* none. Any other number means the same, and is shown. */
};

/* A plug-in describes itself. The struct and its texts live as long as the process. */
typedef struct clipscope_plugin {
  uint32_t struct_size; /* sizeof(clipscope_plugin) */
  uint32_t abi_version; /* CLIPSCOPE_PLUGIN_ABI */
  /* As tables show it: [a-z0-9_.-]+, a folder and '/' may stand before; 60 characters at most, and
   * none of clipscope's own names. */
  const char* name;
  const char* summary;      /* a line: what it does */
  const char* source;       /* a line: whose it is, or after what paper; may be null */
  uint32_t capabilities;    /* bits */
  uint32_t most_attributes; /* 0 to CLIPSCOPE_MOST_ATTRIBUTES, clip distances included */

  /* Clips all primitives of the task: writes `ends`, and the vertices. Called any number of times,
   * by one thread at a time unless CLIPSCOPE_THREAD_SAFE; the same task has the same answer each
   * time, whatever was asked before. It keeps no pointer that it was given, and throws nothing. */
  int32_t (*clip)(const clipscope_task* task, clipscope_answer* answer);
} clipscope_plugin;

#if defined(_WIN32)
#define CLIPSCOPE_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define CLIPSCOPE_EXPORT __attribute__((visibility("default")))
#else
#define CLIPSCOPE_EXPORT
#endif

/* The one function that a plug-in exports. It is given the version that the host speaks; null where
 * the plug-in does not. Called once, before anything else. */
CLIPSCOPE_EXPORT const clipscope_plugin* clipscope_plugin_entry(uint32_t abi_version);

#ifdef __cplusplus
}
#endif

#endif
