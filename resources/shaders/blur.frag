#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One direction of a Gaussian blur; red and green have radii of their own.
uniform sampler2D image;
uniform vec2 direction; // one texel
uniform vec2 sigma;     // of red and of green, texels

in vec2 place;

out vec4 colour;

void main()
{
    vec2 sum = vec2(0.0);
    vec2 weights = vec2(0.0);
    // Far apart samples of a wide blur fall between texels, where the hardware averages for us.
    vec2 stride = max(sigma * (3.0 / 16.0), vec2(1.0));
    for (int i = -16; i <= 16; ++i) {
        vec2 at = float(i) * stride;
        vec2 weight = exp(-0.5 * at * at / (sigma * sigma));
        sum.r += weight.r * texture(image, place + direction * at.r).r;
        sum.g += weight.g * texture(image, place + direction * at.g).g;
        weights += weight;
    }
    colour = vec4(sum / weights, 0.0, 1.0);
}
