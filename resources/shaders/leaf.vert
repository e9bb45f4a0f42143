#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "leaf.glsl"
#include "ambient.glsl"
#ifdef PLAIN
#include "lighting.glsl"
#include "leaflight.glsl"
#endif

uniform float saturation; // of the texture, 0...1: what is grey has no hue to turn
uniform vec3 filmCast;    // of all leaves' colours

out vec2 leafUv;
flat out float leafLot;
#ifdef PLAIN
out vec3 received; // multiplied by the texture's colour
out vec3 shine;
#else
out vec3 worldPosition;
out vec3 worldNormal;
out vec4 worldTangent;
out vec3 outward; // from the crown's middle
out float share;  // of ambient light
flat out vec3 leafTint;
#endif

#ifdef PLAIN
const float kMeanRoughness = 0.5; // of the textures
#endif

// The factors for the texture's colour that turn its hue by an angle, rad. Hue means the hue on the wheel of
// displayed colours; a square root approximates the transfer function well enough for that.
vec3 hueFactor(float angle)
{
    const vec3 shown = vec3(0.305, 0.5, 0.19); // the textures' green
    const float hue = 98.0 / 60.0;
    vec3 k = mod(vec3(5.0, 3.0, 1.0) + hue + angle * (3.0 / 3.14159265), 6.0);
    vec3 turned = 0.5 - 0.31 * clamp(min(k, 4.0 - k), 0.0, 1.0);
    vec3 factor = turned / shown;
    return factor * factor;
}

// The leaves have slightly different greens: some are younger and yellower, some older and bluer.
vec3 leafVariety()
{
    vec3 lot = fract(sin(leafPlace.xyz * mat3(127.1, 311.7, 74.7, 269.5, 183.3, 246.1, 113.5, 271.9, 124.6)) * 43758.5453);
    return (0.8 + 0.4 * lot.x) * mix(vec3(0.86, 0.96, 1.1), vec3(1.2, 1.05, 0.8), lot.y * lot.z);
}

void main()
{
    vec3 place = leafPosition();
    vec3 normal = turned(cardNormal);
    vec3 fromMiddle = normalize((place - frame.crown.xyz) / (frame.crownRadii.xyz * frame.crownRadii.xyz) + vec3(0.0, 1e-4, 0.0));
    float ambient = ambientShare(place) * crownDepth(place);
    vec3 tint = hueFactor(leafLook.y) * leafLook.z * leafVariety();
    tint *= filmCast;
    tint = mix(vec3(dot(tint, vec3(0.21, 0.72, 0.07))), tint, saturation);
    leafUv = cardUv;
    leafLot = lotOfLeaf();
    gl_Position = frame.viewProjection * vec4(place, 1.0);
#ifdef PLAIN
    vec3 toEye = normalize(frame.eye.xyz - place);
    float side = dot(normal, toEye) < 0.0 ? -1.0 : 1.0;
    normal *= side;
    float seen = sunSeenOnLeaf(place);
    LeafLight light = leafLight(place, normal, fromMiddle, side, ambient, seen);
    received = (side > 0.0 ? tint : lowerFace(tint)) * light.reflected + tint * kThrough * light.through;
    shine = leafShine(normal, toEye, kMeanRoughness, side, ambient, seen);
#else
    worldPosition = place;
    worldNormal = normal;
    worldTangent = vec4(turned(cardTangent.xyz), cardTangent.w);
    outward = fromMiddle;
    share = ambient;
    leafTint = tint;
#endif
}
