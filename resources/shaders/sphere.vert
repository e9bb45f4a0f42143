#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A square that covers the perspective picture of a ball.
#include "frame.glsl"

uniform vec3 centre;
uniform float pixelSize; // of the overlay at distance 1, m
uniform float radius; // m
uniform vec3 right;   // of the camera
uniform vec3 up;

out vec3 worldPosition;

void main()
{
    vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
    vec3 offset = frame.eye.xyz - centre;
    float away = length(offset);
    // Tangents from the eye touch the ball nearer than its middle, and widen its outline; and the outline is
    // two pixels wide.
    float near = min(radius / away, 0.98);
    float extent = radius / sqrt(1.0 - near * near) + 4.0 * pixelSize * away;
    worldPosition = centre + extent * 1.03 * (corner.x * right + corner.y * up);
    gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
