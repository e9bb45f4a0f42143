// SPDX-License-Identifier: GPL-3.0-or-later
uniform sampler2D leafColour;

// Small mipmaps lose the thin parts of a leaf: their alpha is raised so that a crown keeps its density from afar.
float leafAlpha(vec2 uv, float alpha)
{
    vec2 texels = uv * vec2(textureSize(leafColour, 0));
    vec2 dx = dFdx(texels);
    vec2 dy = dFdy(texels);
    float level = max(0.0, 0.5 * log2(max(dot(dx, dx), dot(dy, dy))));
    return alpha * (1.0 + 0.25 * level);
}
