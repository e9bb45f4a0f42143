// SPDX-License-Identifier: GPL-3.0-or-later
uniform sampler2D leafColour;

// From afar a texel is a mixture of needles and gaps. A test against half of it would make blobs of them, or
// nothing. So each leaf is tested against a random number, and the covered share of a pixel equals the share
// of needles in it. Near leaves keep their edges. @lot: the random number, evenly spread in 0...1.
bool isGap(vec2 uv, float alpha, float lot)
{
    vec2 texels = uv * vec2(textureSize(leafColour, 0));
    vec2 dx = dFdx(texels);
    vec2 dy = dFdy(texels);
    float level = 0.5 * log2(max(dot(dx, dx), dot(dy, dy)));
    float spread = 0.9 * smoothstep(-0.5, 1.5, level);
    return alpha < 0.5 + (lot - 0.5) * spread;
}

// A random number that differs as much as possible between neighbouring pixels (interleaved gradient noise,
// Jimenez 2014).
float pixelLot(vec2 place)
{
    return fract(52.9829189 * fract(dot(place, vec2(0.06711056, 0.00583715))));
}
