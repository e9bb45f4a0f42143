#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
uniform sampler2D picture;
uniform float opacity;

in vec2 place;

out vec4 colour;

void main()
{
    vec4 texel = texture(picture, place);
    float cover = texel.a * opacity;
    colour = vec4(texel.rgb * cover, cover);
}
