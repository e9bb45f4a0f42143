#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform sampler2D image;

out vec4 colour;

void main()
{
    colour = texelFetch(image, ivec2(gl_FragCoord.xy), 0);
}
