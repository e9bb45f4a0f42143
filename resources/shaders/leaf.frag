#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "lighting.glsl"
#include "leafcolour.glsl"
#include "leaflight.glsl"

uniform sampler2D leafSurface; // normal in tangent space, roughness

in vec2 leafUv;
flat in float leafLot;
#ifdef PLAIN
in vec3 received; // multiplied by the texture's colour
in vec3 shine;
#else
in vec3 worldPosition;
in vec3 worldNormal;
in vec4 worldTangent;
in vec3 outward;
in float share;
flat in vec3 leafTint;
#endif

out vec4 colour;

void main()
{
    vec4 texel = texture(leafColour, leafUv, frame.pass.z);
    // With several passes, each pass has other random numbers; with one, each pixel does.
    float lot = fract(leafLot + (frame.pass.w < 0.0 ? pixelLot(gl_FragCoord.xy) : frame.pass.w));
    if (isGap(leafUv, texel.a, lot))
        discard;
#ifdef PLAIN
    colour = vec4(developed(texel.rgb * received + shine), 1.0);
#else
    float side = gl_FrontFacing ? 1.0 : -1.0;
    vec4 surface = texture(leafSurface, leafUv, frame.pass.z);
    vec3 relief = surface.xyz * 2.0 - 1.0;
    vec3 bitangent = worldTangent.w * cross(worldNormal, worldTangent.xyz);
    vec3 normal = side * normalize(relief.x * worldTangent.xyz + relief.y * bitangent + relief.z * worldNormal);
    vec3 toEye = normalize(frame.eye.xyz - worldPosition);
    float seen = sunSeenOnLeaf(worldPosition);
    LeafLight received = leafLight(worldPosition, normal, outward, side, share, seen);
    vec3 albedo = texel.rgb * leafTint;
    vec3 light = albedo * kThrough * received.through
               + (side > 0.0 ? albedo : lowerFace(albedo)) * received.reflected
               + leafShine(normal, toEye, surface.a, side, share, seen);
    colour = vec4(developed(light), 1.0);
#endif
}
