#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "lighting.glsl"

uniform sampler2D barkColour;
uniform sampler2D barkNormal; // tangent space

in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec2 barkUv;

out vec4 colour;

void main()
{
    vec3 surface = normalize(worldNormal);
    vec3 tangent = normalize(worldTangent.xyz - surface * dot(surface, worldTangent.xyz));
    vec3 bitangent = worldTangent.w * cross(surface, tangent);
    vec3 relief = texture(barkNormal, barkUv).xyz * 2.0 - 1.0;
    vec3 normal = normalize(relief.x * tangent + relief.y * bitangent + relief.z * surface);
    vec3 albedo = texture(barkColour, barkUv).rgb;
    vec3 toEye = normalize(frame.eye.xyz - worldPosition);

    float facing = dot(surface, frame.sunDirection.xyz);
    // A step along the normal keeps the surface out of its own shadow.
    float texel = frame.lightOrigin.w;
    vec3 probe = worldPosition + surface * texel * (1.5 + 2.0 * (1.0 - max(facing, 0.0)));
    float sun = facing > -0.2 ? sunSeen(probe) * max(dot(normal, frame.sunDirection.xyz), 0.0) : 0.0;
    float share = ambientShare(worldPosition + 0.05 * surface);
    // Contact with the ground, and the depth of the furrows, hide a part of the sky.
    float hidden = mix(0.55, 1.0, smoothstep(0.0, 0.35, worldPosition.y)) * mix(0.75, 1.0, relief.z);

    vec3 light = albedo * (ambientLight(normal) * share * hidden + frame.sunColour.rgb * sun);
    light += frame.sunColour.rgb * gloss(normal, toEye, 18.0) * sun * 0.6;
    float rim = pow(1.0 - max(dot(normal, toEye), 0.0), 3.0);
    light += frame.rimColour.rgb * rim * share * hidden * (0.4 + albedo);
    colour = vec4(developed(light), 1.0);
}
