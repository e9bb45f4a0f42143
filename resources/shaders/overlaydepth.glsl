// SPDX-License-Identifier: GPL-3.0-or-later
// The scene behind an overlay.

uniform sampler2D sceneDepth;
uniform vec2 overlaySize; // px

// 1 in front of the scene, less behind it.
float nearness(float depth)
{
    float behind = texture(sceneDepth, gl_FragCoord.xy / overlaySize).r;
    return depth <= behind ? 1.0 : 0.35;
}
