// SPDX-License-Identifier: GPL-3.0-or-later
// Functions of light and colour for all lit surfaces.

uniform sampler2DShadow shadowMap;

// A filmic curve: a toe that keeps dark colours dark, a straight middle and a shoulder for bright light;
// after Narkowicz's fit of ACES. Then the transfer function of sRGB.
vec3 developed(vec3 light)
{
    vec3 x = light * frame.crownRadii.w;
    x = clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
    // Three roots come within half a step of the transfer function, and cost less than its power.
    vec3 root = sqrt(x);
    vec3 fourth = sqrt(root);
    return max(0.585122381 * root + 0.783140355 * fourth - 0.368262736 * sqrt(fourth), 0.0);
}

// The place of a position in the shadow map; positions beyond the tree, seen from the sun, get the greatest
// depth.
vec3 shadowPlace(vec3 position)
{
    vec3 place = (frame.shadowFromWorld * vec4(position, 1.0)).xyz;
    return vec3(place.xy, min(place.z, 0.9999));
}

// Whether the sun is visible: 1 in light, 0 in shadow; for things too small to show a shadow's edge.
float sunSeenRoughly(vec3 position)
{
    return mix(1.0, texture(shadowMap, shadowPlace(position)), frame.sunDirection.w);
}

// The same with an edge that several passes make about two texels wide.
float sunSeen(vec3 position)
{
    vec3 place = shadowPlace(position);
    place.xy += frame.pass.xy * (1.5 / vec2(textureSize(shadowMap, 0)));
    return mix(1.0, texture(shadowMap, place), frame.sunDirection.w);
}

// Normalised Blinn-Phong, its power as Schlick's fraction, with Schlick's Fresnel term for a surface that
// reflects 4 % at a right angle. The power suits a surface with GGX's roughness.
float gloss(vec3 normal, vec3 toEye, float roughness)
{
    float spread = max(roughness * roughness, 0.03);
    float power = 2.0 / (spread * spread);
    vec3 halfway = normalize(toEye + frame.sunDirection.xyz);
    float away = 1.0 - max(dot(halfway, toEye), 0.0);
    float fresnel = 0.04 + 0.96 * away * away * away * away * away;
    float lobe = max(dot(normal, halfway), 0.0);
    return fresnel * (power + 8.0) / 25.0 * lobe / (power - power * lobe + lobe);
}
