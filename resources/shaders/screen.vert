#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One triangle that covers the view; needs no buffers.
out vec2 place; // 0...1

void main()
{
    place = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(2.0 * place - 1.0, 1.0, 1.0);
}
