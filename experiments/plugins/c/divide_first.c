/* SPDX-License-Identifier: MIT
 *
 * A clipper as a plug-in of clipscope, in C99: divide by w, then cut against the cube.
 *
 * Its bug is the one of everybody's first renderer: a vertex behind the eye, where w < 0, is divided
 * like any other and comes out in front of it, mirrored.
 */
#include <math.h>
#include <string.h>

#include "clipscope_plugin.h"

enum { MOST_NUMBERS = 4 + CLIPSCOPE_MOST_ATTRIBUTES, MOST_VERTICES = 16 };

/* x y z 1/w, then attributes. While it is cut these are divided by w, so that all are linear. */
typedef struct {
  float numbers[MOST_NUMBERS];
} vertex;

typedef struct {
  vertex vertices[MOST_VERTICES];
  size_t size;
} polygon;

static vertex divided(const float* in, size_t stride) {
  vertex v;
  const float inv_w = 1.0f / in[3];
  for (size_t i = 0; i < stride; ++i) v.numbers[i] = in[i] * inv_w;
  v.numbers[3] = inv_w;
  return v;
}

/* From the plane sign * coordinate = 1; >= 0 is inside. */
static float distance(const vertex* v, int axis, float sign) { return 1.0f - sign * v->numbers[axis]; }

static vertex between(const vertex* a, const vertex* b, float t, size_t stride) {
  vertex v;
  for (size_t i = 0; i < stride; ++i) {
    v.numbers[i] = a->numbers[i] + t * (b->numbers[i] - a->numbers[i]);
  }
  return v;
}

/* Sutherland and Hodgman, Reentrant Polygon Clipping, 1974: one plane. */
static void cut(polygon* p, int axis, float sign, size_t stride) {
  polygon out = {.size = 0};
  for (size_t i = 0; i < p->size; ++i) {
    const vertex* const a = &p->vertices[i];
    const vertex* const b = &p->vertices[(i + 1) % p->size];
    const float d_a = distance(a, axis, sign), d_b = distance(b, axis, sign);
    if (d_a >= 0) out.vertices[out.size++] = *a;
    if ((d_a >= 0) != (d_b >= 0)) {
      vertex v = between(a, b, d_a / (d_a - d_b), stride);
      v.numbers[axis] = sign;
      out.vertices[out.size++] = v;
    }
  }
  *p = out;
}

static int is_finite(const float* triangle, size_t stride) {
  for (size_t v = 0; v < 3; ++v) {
    for (size_t i = 0; i < 4; ++i) {
      if (!isfinite(triangle[v * stride + i])) return 0;
    }
  }
  return 1;
}

static polygon clipped(const float* triangle, size_t stride) {
  polygon p = {.size = 0};
  if (!is_finite(triangle, stride)) return p;
  for (p.size = 0; p.size < 3; ++p.size) {
    p.vertices[p.size] = divided(triangle + p.size * stride, stride);
  }
  for (int axis = 0; axis < 3; ++axis) {
    cut(&p, axis, -1.0f, stride);
    cut(&p, axis, 1.0f, stride);
  }
  return p;
}

static int32_t clip(const clipscope_task* task, clipscope_answer* answer) {
  const size_t stride = task->stride;
  size_t end = 0;
  for (size_t i = 0; i < task->count; ++i) {
    const polygon p = clipped(task->floats + i * 3 * stride, stride);
    if (end + p.size > answer->capacity) return CLIPSCOPE_FAILED;
    for (size_t v = 0; v < p.size; ++v, ++end) {
      const float* const numbers = p.vertices[v].numbers;
      float* const out = answer->floats + end * stride;
      memcpy(out, numbers, 4 * sizeof *out);
      for (size_t k = 4; k < stride; ++k) out[k] = numbers[k] / numbers[3];
    }
    answer->ends[i] = end;
  }
  return CLIPSCOPE_DONE;
}

const clipscope_plugin* clipscope_plugin_entry(uint32_t abi_version) {
  static const clipscope_plugin plugin = {
      .struct_size = sizeof(clipscope_plugin),
      .abi_version = CLIPSCOPE_PLUGIN_ABI,
      .name = "example/divide_first",
      .summary = "divide, then cut; triangles behind the eye are mirrored",
      .source = "an example, with a bug",
      .capabilities = CLIPSCOPE_FLOAT | CLIPSCOPE_CLIP_SPACE | CLIPSCOPE_TRIANGLES |
                      CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE | CLIPSCOPE_THREAD_SAFE,
      .most_attributes = CLIPSCOPE_MOST_ATTRIBUTES,
      .clip = clip};
  return abi_version == CLIPSCOPE_PLUGIN_ABI ? &plugin : NULL;
}
