// SPDX-License-Identifier: GPL-3.0-or-later
// The light on a leaf.

// Light that passes through a blade is yellower and more saturated than reflected light.
const vec3 kThrough = vec3(1.5, 1.3, 0.35);

struct LeafLight {
    vec3 reflected; // multiplied by the leaf's colour
    vec3 through;   // multiplied by the leaf's colour and kThrough
};

// @normal: of the visible face; @outward: from the crown's middle; @side: 1 for the upper face, -1 for the
// lower; @share: of ambient light; @seen: share of the sun that is visible.
LeafLight leafLight(vec3 position, vec3 normal, vec3 outward, float side, float share, float seen)
{
    vec3 toEye = normalize(frame.eye.xyz - position);
    vec3 sun = frame.sunDirection.xyz;
    // Thousands of leaves that each face their own way look like noise; leaning them toward the outside of the crown
    // shows its form.
    vec3 shaped = normalize(mix(normal, outward, 0.45));
    float front = max(mix(dot(normal, sun), dot(shaped, sun), 0.6), 0.0);
    // Brightest against the sun.
    float behind = max(-dot(normal, sun), 0.0);
    float against = max(-dot(toEye, sun), 0.0);
    against *= against;
    LeafLight light;
    light.reflected = mix(frame.groundColour.rgb, frame.skyColour.rgb, 0.5 + 0.5 * shaped.y) * share
                    + frame.sunColour.rgb * (seen * front);
    light.through = frame.sunColour.rgb * (seen * behind * (0.55 + 1.1 * against * against))
    // Light that leaves reflect onto each other keeps the inside green instead of grey.
                  + frame.sunColour.rgb * (0.11 * share + 0.018);
    return light;
}

// Whether the sun is visible from a leaf. A step toward it keeps the leaf out of its own shadow.
float sunSeenOnLeaf(vec3 position)
{
    return sunSeenRoughly(position + frame.sunDirection.xyz * frame.lightOrigin.w * 2.5);
}

// The light of sun and sky that a leaf's waxy face mirrors; as for leafLight.
vec3 leafShine(vec3 normal, vec3 toEye, float roughness, float side, float share, float seen)
{
    vec3 sun = frame.sunDirection.xyz;
    vec3 shine = frame.sunColour.rgb * (seen * gloss(normal, toEye, roughness) * (side > 0.0 ? 0.8 : 0.15) * step(0.0, dot(normal, sun)));
    // The reflection of the sky, strongest at grazing angles.
    float glance = 1.0 - abs(dot(normal, toEye));
    glance *= glance;
    float up = 0.5 + 0.5 * reflect(-toEye, normal).y;
    return shine + frame.skyColour.rgb * ((0.02 + 0.35 * glance * glance) * share * share * (side > 0.0 ? 0.5 : 0.15) * up);
}

// The lower face is paler and rougher.
vec3 lowerFace(vec3 albedo)
{
    return mix(albedo, vec3(dot(albedo, vec3(0.3, 0.6, 0.1))), 0.22) * 1.2;
}
