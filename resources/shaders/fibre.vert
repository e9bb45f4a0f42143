#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec4 tint;

out vec3 fibreTint;

void main()
{
    fibreTint = tint.rgb;
    gl_Position = frame.viewProjection * vec4(position, 1.0);
}
