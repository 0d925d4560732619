// SPDX-License-Identifier: GPL-3.0-or-later
// Writes what it is asked for and reads nothing else. FACING ... FRAG_COORD: 0 or 1 each; attachment
// 0 is always there, each further one asked for follows in this order.
#version 450

layout(location = 0) out vec4 covered_facing_id;
#if SMOOTH
layout(location = 0) smooth in vec4 smooth_varying;
layout(location = 1) out vec4 smooth_out;
#endif
#if NOPERSPECTIVE
layout(location = 1) noperspective in vec4 noperspective_varying;
layout(location = 1 + SMOOTH) out vec4 noperspective_out;
#endif
#if FLAT
layout(location = 2) flat in vec4 flat_varying;
layout(location = 1 + SMOOTH + NOPERSPECTIVE) out vec4 flat_out;
#endif
#if FRAG_COORD
layout(location = 1 + SMOOTH + NOPERSPECTIVE + FLAT) out vec4 frag_coord_out;
#endif

void main() {
  covered_facing_id = vec4(1, 0, 0, 0);
#if FACING
  covered_facing_id.y = gl_FrontFacing ? 1 : -1;
#endif
#if PRIMITIVE_ID
  covered_facing_id.z = float(gl_PrimitiveID);
#endif
#if SMOOTH
  smooth_out = smooth_varying;
#endif
#if NOPERSPECTIVE
  noperspective_out = noperspective_varying;
#endif
#if FLAT
  flat_out = flat_varying;
#endif
#if FRAG_COORD
  frag_coord_out = gl_FragCoord;
#endif
}
