// SPDX-License-Identifier: GPL-3.0-or-later
// The vertices are in clip coordinates already, and pass. CLIP_DISTANCES: how many, 0 to 8.
#version 450

layout(location = 0) in vec4 position;
layout(location = 1) in vec4 values;
layout(location = 2) in vec4 first_distances;
layout(location = 3) in vec4 last_distances;

layout(location = 0) out vec4 smooth_varying;
layout(location = 1) out vec4 noperspective_varying;
layout(location = 2) out vec4 flat_varying;

layout(push_constant) uniform Constants { float point_size; };

out gl_PerVertex {
  vec4 gl_Position;
  float gl_PointSize;
#if CLIP_DISTANCES > 0
  float gl_ClipDistance[CLIP_DISTANCES];
#endif
};

void main() {
  gl_Position = position;
  gl_PointSize = point_size;
  smooth_varying = values;
  noperspective_varying = values;
  flat_varying = values;
#if CLIP_DISTANCES > 0
  const float distances[8] =
      float[8](first_distances.x, first_distances.y, first_distances.z, first_distances.w,
               last_distances.x, last_distances.y, last_distances.z, last_distances.w);
  for (int i = 0; i < CLIP_DISTANCES; ++i) gl_ClipDistance[i] = distances[i];
#endif
}
