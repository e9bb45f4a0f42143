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
#include "lighting.glsl"
#include "barklight.glsl"
out vec3 received; // multiplied by the texture's colour
out vec3 shine;
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
    // With the means of the textures' relief and roughness.
    vec3 toEye = normalize(frame.eye.xyz - place);
    float sun = 0.88 * sunOnBark(place, normal, normal);
    vec3 sky = barkAmbient(place, normal, 0.7, ambient);
    received = soiled(place) * (sky + frame.sunColour.rgb * sun + rimLight(normal, toEye) * sky);
    shine = frame.sunColour.rgb * gloss(normal, toEye, 0.7) * sun + 0.4 * rimLight(normal, toEye) * sky;
#else
    share = ambient;
    worldPosition = place;
    worldNormal = normal;
    worldTangent = tangent;
#endif
}
