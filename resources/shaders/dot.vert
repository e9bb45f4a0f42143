#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"

layout(location = 0) in vec3 position;

uniform float size; // px, with the halo

void main()
{
    gl_Position = frame.viewProjection * vec4(position, 1.0);
    gl_PointSize = size;
}
