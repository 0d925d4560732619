// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the clip distances, and 0 for those that there are not. CLIP_DISTANCES: how many, 1 to 8.
#version 450

in float gl_ClipDistance[CLIP_DISTANCES];

layout(location = 0) out vec4 first_distances;
layout(location = 1) out vec4 last_distances;

void main() {
  float distances[8] = float[8](0, 0, 0, 0, 0, 0, 0, 0);
  for (int i = 0; i < CLIP_DISTANCES; ++i) distances[i] = gl_ClipDistance[i];
  first_distances = vec4(distances[0], distances[1], distances[2], distances[3]);
  last_distances = vec4(distances[4], distances[5], distances[6], distances[7]);
}
