#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "leafcolour.glsl"

in vec2 leafUv;

out vec4 coverage;

void main()
{
    if (leafAlpha(leafUv, texture(leafColour, leafUv).a) < 0.5)
        discard;
    coverage = vec4(1.0);
}
