// SPDX-License-Identifier: GPL-3.0-or-later
// The scene behind an overlay.

uniform sampler2D sceneDepth;
uniform vec2 overlaySize;   // px
uniform vec2 overlayOrigin; // px, in the framebuffer

// 1 in front of the scene, less behind it.
float nearness(float depth)
{
    float behind = texture(sceneDepth, (gl_FragCoord.xy - overlayOrigin) / overlaySize).r;
    return depth <= behind ? 1.0 : 0.35;
}
