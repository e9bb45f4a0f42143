#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
out vec4 coverage;

void main()
{
    coverage = vec4(1.0);
}
