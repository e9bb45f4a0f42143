// SPDX-License-Identifier: GPL-3.0-or-later
// Light and colour, shared by what is lit.

uniform sampler3D lightVolume;
uniform sampler2DShadow shadowMap;

// Filmic curve after Narkowicz's fit of ACES, then the transfer function of sRGB.
vec3 developed(vec3 light)
{
    vec3 x = light * frame.crownRadii.w;
    x = clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
    return mix(12.92 * x, 1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}

// The share of ambient light that reaches a point within the crown, by the light of the growth model
// (TreeSketch 3.5; algorithms N: mix(a_min, 1, L^gamma)).
float ambientShare(vec3 position)
{
    float light = texture(lightVolume, (position - frame.lightOrigin.xyz) * frame.lightScale.xyz).r;
    return mix(frame.lightScale.w, 1.0, pow(light, frame.crown.w));
}

vec3 ambientLight(vec3 normal)
{
    return mix(frame.groundColour.rgb, frame.skyColour.rgb, 0.5 + 0.5 * normal.y);
}

// Where a position is in the shadow map; what lies beyond the tree, seen from the sun, is as deep as the map goes.
vec3 shadowPlace(vec3 position)
{
    vec3 place = (frame.shadowFromWorld * vec4(position, 1.0)).xyz;
    return vec3(place.xy, min(place.z, 0.9999));
}

// Whether the sun is seen: 1 in light, 0 in shadow; for what is too small to show a shadow's edge.
float sunSeenRoughly(vec3 position)
{
    if (frame.sunDirection.w <= 0.0)
        return 1.0;
    return mix(1.0, texture(shadowMap, shadowPlace(position)), frame.sunDirection.w);
}

// The same with an edge that is about two texels wide.
float sunSeen(vec3 position)
{
    if (frame.sunDirection.w <= 0.0)
        return 1.0;
    vec3 place = shadowPlace(position);
    vec2 texel = 0.75 / vec2(textureSize(shadowMap, 0));
    float seen = texture(shadowMap, vec3(place.xy + texel * vec2(-1.0, -0.35), place.z))
               + texture(shadowMap, vec3(place.xy + texel * vec2(0.35, -1.0), place.z))
               + texture(shadowMap, vec3(place.xy + texel * vec2(1.0, 0.35), place.z))
               + texture(shadowMap, vec3(place.xy + texel * vec2(-0.35, 1.0), place.z));
    return mix(1.0, 0.25 * seen, frame.sunDirection.w);
}

// Normalised Blinn-Phong with Schlick's Fresnel term for a surface that reflects 4 % at a right angle.
float gloss(vec3 normal, vec3 toEye, float power)
{
    vec3 halfway = normalize(toEye + frame.sunDirection.xyz);
    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(halfway, toEye), 0.0), 5.0);
    return fresnel * (power + 8.0) / 25.0 * pow(max(dot(normal, halfway), 0.0), power);
}
