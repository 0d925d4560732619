// SPDX-License-Identifier: GPL-3.0-or-later
// Added up by the blending: fragments, and those of them that are front-facing.
#version 450

layout(location = 0) out vec4 hits;

void main() { hits = vec4(1, gl_FrontFacing ? 1 : 0, 0, 0); }
