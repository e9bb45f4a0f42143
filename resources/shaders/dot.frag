#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaydepth.glsl"

uniform float size;   // px, with the halo
uniform float middle; // px, diameter of the bright part
uniform float glow;   // 0...1
uniform vec4 tint;

out vec4 colour;

void main()
{
    float away = length(gl_PointCoord - 0.5) * size;
    float core = clamp(0.5 * middle + 0.5 - away, 0.0, 1.0);
    float fall = clamp(1.0 - 2.0 * away / size, 0.0, 1.0);
    float halo = glow * fall * fall * 0.35;
    float shown = tint.w * nearness(gl_FragCoord.z);
    // The halo adds its light; the middle covers what is behind it.
    colour = vec4(tint.rgb * (core + halo * (1.0 - core)) * shown, core * shown);
}
