#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A translucent surface: clear where it faces the camera, denser where it is seen edge-on.
#include "frame.glsl"
#include "overlaydepth.glsl"

uniform vec4 tint; // w: opacity at the rim

in vec3 worldPosition;
in vec3 worldNormal;

out vec4 colour;

void main()
{
    vec3 normal = normalize(worldNormal);
    vec3 view = normalize(frame.eye.xyz - worldPosition);
    float away = 1.0 - clamp(dot(normal, view), 0.0, 1.0);
    float lit = 0.7 + 0.4 * max(dot(normal, frame.sunDirection.xyz), 0.0);
    float opacity = tint.w * mix(0.22, 1.0, away * away) * nearness(gl_FragCoord.z);
    colour = vec4(tint.rgb * lit * opacity, opacity);
}
