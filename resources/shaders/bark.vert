#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

// Twigs thinner than a pixel would break into dots: each surface moves out by this many pixels.
uniform float widening;

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec2 barkUv;

void main()
{
    float pixel = frame.eye.w * distance(position, frame.eye.xyz);
    worldPosition = position + normal * (widening * pixel);
    worldNormal = normal;
    worldTangent = tangent;
    barkUv = uv;
    gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
