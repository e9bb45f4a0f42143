#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One direction of a Gaussian blur.
uniform sampler2D image;
uniform vec2 direction; // offset of one sample
uniform float sigma;    // samples
uniform int reach;      // samples

in vec2 place;

out vec4 colour;

void main()
{
    vec4 sum = vec4(0.0);
    float weights = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        float weight = exp(-0.5 * float(i * i) / (sigma * sigma));
        sum += weight * texture(image, place + direction * float(i));
        weights += weight;
    }
    colour = sum / weights;
}
