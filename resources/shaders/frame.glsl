// SPDX-License-Identifier: GPL-3.0-or-later
// The uniforms of all programs of one picture; FrameUniforms.h has the same fields in the same order.
layout(std140) uniform Frame {
    mat4 viewProjection;
    mat4 inverseViewProjection;
    mat4 shadowFromWorld;   // to texture coordinates and depth of the shadow map
    vec4 eye;               // xyz; w: size of a pixel at distance 1, m
    vec4 sunDirection;      // toward the sun; w: 1 shows its shadows
    vec4 sunColour;
    vec4 skyColour;         // ambient light from above
    vec4 groundColour;      // ambient light from below
    vec4 rimColour;         // cool light from behind that separates the tree from a dark background
    vec4 lightOrigin;       // corner of the light volume; w: edge of a shadow map's texel, m
    vec4 lightScale;        // 1 / its size; w: least share of ambient light, a_min
    vec4 crown;             // centre; w: exponent of the light, gamma
    vec4 crownRadii;        // half-extents of the tree; w: exposure
    vec4 viewSize;          // px; zw: 1 / px
    vec4 backgroundInner;   // as shown (sRGB), or lower; w: 0 dark studio, 1 horizon, 2 gradient, 3 none, 4 light studio
    vec4 backgroundOuter;   // as shown (sRGB), or upper
    vec4 ground;            // albedo; w: radius of the ground, m
    vec4 foot;              // x: radius of the thickest trunk at the ground, m; y: 1 shows the ground; z: 1 shows its grid; w: number of feet
    vec4 pass;              // xy: place within the pixel, -0.5...0.5; z: bias of the textures' levels; w: its share of lots, 0...1, or -1 if there is but one pass
    vec4 groundShadow;      // x: half the edge of the square that the ground's shadows are drawn on, m
    vec4 feet[8];           // of the trunks: xy: place on the ground (x and z), m; z: radius, m
} frame;
