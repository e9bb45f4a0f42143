#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"

uniform vec3 centre;
uniform vec3 halfRight;
uniform vec3 halfUp;

out vec2 place;

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1));
    place = corner;
    corner = 2.0 * corner - 1.0;
    gl_Position = frame.viewProjection * vec4(centre + corner.x * halfRight + corner.y * halfUp, 1.0);
    gl_Position.z = gl_Position.w; // behind everything
}
