#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "leafcolour.glsl"

in vec2 leafUv;
flat in float leafLot;

out vec4 coverage;

void main()
{
    if (isGap(leafUv, texture(leafColour, leafUv).a, fract(leafLot + pixelLot(gl_FragCoord.xy))))
        discard;
    coverage = vec4(1.0);
}
