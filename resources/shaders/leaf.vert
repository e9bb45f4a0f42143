#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "leaf.glsl"

out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec2 leafUv;
flat out vec2 leafTint; // shift of the hue, brightness

void main()
{
    worldPosition = leafPosition();
    worldNormal = turned(cardNormal);
    worldTangent = vec4(turned(cardTangent.xyz), cardTangent.w);
    leafUv = cardUv;
    leafTint = leafLook.yz;
    gl_Position = frame.viewProjection * vec4(worldPosition, 1.0);
}
