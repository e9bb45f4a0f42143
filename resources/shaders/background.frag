#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "background.glsl"

in vec2 place;

out vec4 colour;

void main()
{
    colour = vec4(backdrop(place) + dithering(), 1.0);
}
