#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"

out vec2 groundPlace; // -1...1

void main()
{
    groundPlace = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    gl_Position = frame.viewProjection * vec4(frame.ground.w * vec3(groundPlace.x, 0.0, groundPlace.y), 1.0);
}
