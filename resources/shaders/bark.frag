#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "lighting.glsl"
#include "barklight.glsl"

uniform sampler2D barkColour;
uniform sampler2D barkSurface; // normal in tangent space, roughness

in vec2 barkUv;
#ifdef PLAIN
in vec3 received; // multiplied by the texture's colour
in vec3 shine;
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
    colour = vec4(developed(albedo * received + shine), 1.0);
#else
    vec3 surface = normalize(worldNormal);
    vec3 bitangent = worldTangent.w * cross(surface, worldTangent.xyz);
    vec4 skin = texture(barkSurface, barkUv, frame.pass.z);
    vec3 relief = skin.xyz * 2.0 - 1.0;
    vec3 normal = normalize(relief.x * worldTangent.xyz + relief.y * bitangent + relief.z * surface);
    vec3 toEye = normalize(frame.eye.xyz - worldPosition);

    float sun = sunOnBark(worldPosition, surface, normal);
    vec3 ambient = barkAmbient(worldPosition, normal, max(relief.z, 0.0), share);
    albedo *= soiled(worldPosition);
    vec3 light = albedo * (ambient + frame.sunColour.rgb * sun)
               + frame.sunColour.rgb * gloss(normal, toEye, skin.a) * sun
               + rimLight(normal, toEye) * ambient * (0.4 + albedo);
    colour = vec4(developed(light), 1.0);
#endif
}
