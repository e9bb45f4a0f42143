#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaydepth.glsl"

uniform float extent;  // m
uniform float spacing; // m
uniform vec2 phase;    // m, of the lines
uniform vec4 tint;

in vec2 place;
in vec3 worldPosition;

out vec4 colour;

void main()
{
    vec2 cell = (place - phase) / spacing;
    vec2 pixel = fwidth(cell);
    vec2 line = 1.0 - smoothstep(0.5, 1.5, abs(fract(cell + 0.5) - 0.5) / pixel);
    float fade = 1.0 - smoothstep(0.2, 1.0, length(place) / extent);
    // The user does not draw below ground.
    float above = worldPosition.y < 0.0 ? 0.3 : 1.0;
    float opacity = tint.w * max(line.x, line.y) * fade * above * nearness(gl_FragCoord.z);
    colour = vec4(tint.rgb * opacity, opacity);
}
