#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later

in vec3 fibreTint;

out vec4 colour;

void main()
{
    colour = vec4(fibreTint, 1.0);
}
