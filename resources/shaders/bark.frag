#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "lighting.glsl"
#include "barklight.glsl"

uniform sampler2D barkColour;
uniform sampler2D barkSurface; // normal in tangent space, roughness

in vec2 barkUv;
#ifdef PLAIN
in vec3 received;
#else
in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in float share;
#endif

out vec4 colour;

void main()
{
    vec3 albedo = texture(barkColour, barkUv, frame.pass.z).rgb;
#ifdef PLAIN
    colour = vec4(developed(albedo * received), 1.0);
#else
    vec3 surface = normalize(worldNormal);
    vec3 bitangent = worldTangent.w * cross(surface, worldTangent.xyz);
    vec4 skin = texture(barkSurface, barkUv, frame.pass.z);
    vec3 relief = skin.xyz * 2.0 - 1.0;
    vec3 normal = normalize(relief.x * worldTangent.xyz + relief.y * bitangent + relief.z * surface);
    vec3 toEye = normalize(frame.eye.xyz - worldPosition);

    float facing = dot(surface, frame.sunDirection.xyz);
    // A step along the normal keeps the surface out of its own shadow.
    float texel = frame.lightOrigin.w;
    vec3 probe = worldPosition + surface * texel * (1.5 + 2.0 * (1.0 - max(facing, 0.0)));
    float sun = sunSeen(probe) * max(dot(normal, frame.sunDirection.xyz), 0.0) * smoothstep(-0.2, 0.1, facing);

    vec3 ambient = barkAmbient(worldPosition, normal, max(relief.z, 0.0), share);
    // The foot of the trunk has the colour of splashed soil.
    albedo *= mix(vec3(0.62, 0.58, 0.5), vec3(1.0), smoothstep(-0.5, 4.0, worldPosition.y / frame.foot.x));
    vec3 light = albedo * (ambient + frame.sunColour.rgb * sun);
    light += frame.sunColour.rgb * gloss(normal, toEye, skin.a) * sun;
    float rim = 1.0 - max(dot(normal, toEye), 0.0);
    rim *= rim * rim;
    light += frame.rimColour.rgb * rim * ambient * (0.4 + albedo);
    colour = vec4(developed(light), 1.0);
#endif
}
