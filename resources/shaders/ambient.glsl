// SPDX-License-Identifier: GPL-3.0-or-later
// Ambient light, computed for vertices: it changes little over a leaf or a ring of bark.

uniform sampler3D lightVolume;

// The share of ambient light that reaches a point within the crown, by the light of the growth model
// (TreeSketch 3.5): mix(a_min, 1, L^gamma).
float ambientShare(vec3 position)
{
    vec3 place = (position - frame.lightOrigin.xyz) * frame.lightScale.xyz;
    float light = textureLod(lightVolume, place, 0.0).r;
    return mix(frame.lightScale.w, 1.0, pow(light, frame.crown.w));
}

// The share of light that a crown hides from places far within it; L only contains shadow from above.
float crownDepth(vec3 position)
{
    vec3 inside = (position - frame.crown.xyz) / frame.crownRadii.xyz;
    return mix(0.7, 1.0, smoothstep(0.05, 0.85, dot(inside, inside)));
}
