#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
layout(location = 0) in vec3 position;

uniform mat4 clipFromWorld;

void main()
{
    gl_Position = clipFromWorld * vec4(position, 1.0);
}
