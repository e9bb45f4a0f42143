#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "leaf.glsl"

uniform mat4 clipFromWorld;

out vec2 leafUv;
flat out float leafLot;

void main()
{
    leafUv = cardUv;
    leafLot = lotOfLeaf();
    gl_Position = clipFromWorld * vec4(leafPosition(), 1.0);
}
