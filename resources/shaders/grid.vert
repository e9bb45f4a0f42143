#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"

uniform vec3 centre;
uniform vec3 right;
uniform vec3 up;
uniform float extent; // m

out vec2 place; // m from the middle
out vec3 worldPosition;

void main()
{
    place = extent * (vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0);
    worldPosition = centre + place.x * right + place.y * up;
    gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
