#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "ambient.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 tangent;
layout(location = 3) in vec2 uv;

// Twigs thinner than a pixel would break into dots: each surface moves out by this many pixels.
uniform float widening;

out vec2 barkUv;
#ifdef PLAIN
out vec3 received;
#include "barklight.glsl"
#else
out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out float share; // of ambient light
#endif

void main()
{
    float pixel = frame.eye.w * distance(position, frame.eye.xyz);
    vec3 place = position + normal * (widening * pixel);
    float ambient = ambientShare(place + 0.05 * normal);
    barkUv = uv;
    gl_Position = frame.viewProjection * vec4(place, 1.0);
#ifdef PLAIN
    // The mean of the relief.
    received = barkAmbient(place, normal, 0.8, ambient)
             + frame.sunColour.rgb * max(dot(normal, frame.sunDirection.xyz), 0.0) * plainSun(ambient);
#else
    share = ambient;
    worldPosition = place;
    worldNormal = normal;
    worldTangent = tangent;
#endif
}
