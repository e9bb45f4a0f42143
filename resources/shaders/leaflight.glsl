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
