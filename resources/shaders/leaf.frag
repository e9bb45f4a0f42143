#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "lighting.glsl"
#include "leafcolour.glsl"

uniform sampler2D leafNormals; // tangent space
uniform bool alphaToCoverage;

in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec2 leafUv;
flat in vec2 leafTint;

out vec4 colour;

// The colour with its hue turned by an angle, rad. Hue is meant as people pick it, on the wheel of displayed colours; a
// square root is near enough to the transfer function for that.
vec3 hueTurned(vec3 light, float angle)
{
    vec3 shown = sqrt(light);
    float value = max(shown.r, max(shown.g, shown.b));
    float least = min(shown.r, min(shown.g, shown.b));
    float chroma = max(value - least, 1e-5);
    float hue = shown.r == value ? (shown.g - shown.b) / chroma
              : shown.g == value ? (shown.b - shown.r) / chroma + 2.0
                                 : (shown.r - shown.g) / chroma + 4.0;
    hue += angle * (3.0 / 3.14159265);
    vec3 k = mod(vec3(5.0, 3.0, 1.0) + hue, 6.0);
    vec3 result = value - chroma * clamp(min(k, 4.0 - k), 0.0, 1.0);
    return result * result;
}

void main()
{
    vec4 texel = texture(leafColour, leafUv);
    float alpha = leafAlpha(leafUv, texel.a);
    if (alphaToCoverage) {
        alpha = clamp((alpha - 0.5) / max(fwidth(alpha), 1e-3) + 0.5, 0.0, 1.0);
        if (alpha <= 0.0)
            discard;
    } else if (alpha < 0.5) {
        discard;
    }
    vec3 albedo = hueTurned(texel.rgb, leafTint.x) * leafTint.y;
    // Under a warm sun and a filmic curve, leaves as they are would look like paint.
    albedo = vec3(0.88, 0.82, 0.7) * mix(vec3(dot(albedo, vec3(0.21, 0.72, 0.07))), albedo, 0.78);

    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec3 face = normalize(worldNormal);
    vec3 tangent = normalize(worldTangent.xyz - face * dot(face, worldTangent.xyz));
    vec3 relief = texture(leafNormals, leafUv).xyz * 2.0 - 1.0;
    vec3 normal = side * normalize(relief.x * tangent + relief.y * worldTangent.w * cross(face, tangent) + relief.z * face);
    vec3 toEye = normalize(frame.eye.xyz - worldPosition);
    vec3 sun = frame.sunDirection.xyz;

    // Thousands of leaves that each face their own way look like noise; leaning them toward the outside of the crown
    // shows its form.
    vec3 outward = (worldPosition - frame.crown.xyz) / (frame.crownRadii.xyz * frame.crownRadii.xyz);
    vec3 shaped = normalize(mix(normal, normalize(outward + vec3(0.0, 1e-4, 0.0)), 0.5));

    float seen = sunSeenRoughly(worldPosition + sun * frame.lightOrigin.w * 2.5);
    float share = ambientShare(worldPosition);
    float front = max(dot(shaped, sun), 0.0);
    // What shines through a blade is yellower and richer than what it reflects, and brightest against the sun.
    float behind = max(-dot(normal, sun), 0.0);
    float glow = pow(max(-dot(toEye, sun), 0.0), 4.0);
    vec3 through = albedo * vec3(1.25, 1.2, 0.55);
    // The lower face is paler.
    albedo = side > 0.0 ? albedo : mix(albedo, vec3(dot(albedo, vec3(0.3, 0.6, 0.1))), 0.18) * 1.15;

    vec3 light = albedo * ambientLight(shaped) * share;
    light += frame.sunColour.rgb * seen * (albedo * front + through * behind * (0.55 + 0.8 * glow));
    // Light that leaves hand on to each other keeps the inside green rather than grey.
    light += albedo * albedo * frame.sunColour.rgb * (0.3 * share);
    light += frame.sunColour.rgb * seen * gloss(normal, toEye, 26.0) * (side > 0.0 ? 0.7 : 0.2)
             * step(0.0, dot(normal, sun));
    float rim = pow(1.0 - abs(dot(normal, toEye)), 3.0);
    light += frame.rimColour.rgb * rim * share * 0.25;
    colour = vec4(developed(light), alphaToCoverage ? alpha : 1.0);
}
