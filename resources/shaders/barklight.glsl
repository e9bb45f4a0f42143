// SPDX-License-Identifier: GPL-3.0-or-later
// The ambient light on bark.

vec3 ambientLight(vec3 normal)
{
    return mix(frame.groundColour.rgb, frame.skyColour.rgb, 0.5 + 0.5 * normal.y);
}

// @relief: 1 on ridges, less on the flanks of furrows.
vec3 barkAmbient(vec3 position, vec3 normal, float relief, float share)
{
    // The ground hides half of the sky from what stands on it, and soil clings to the foot.
    float foot = smoothstep(-0.3, 3.0, position.y / frame.foot.x);
    float hidden = mix(0.4, 1.0, foot) * mix(0.5, 1.0, relief * relief);
    return ambientLight(normal) * (share * hidden);
}

#ifdef PLAIN
// While shadows are not drawn, the sun counts as hidden where the sky is.
float plainSun(float share)
{
    return smoothstep(0.1, 0.9, share);
}
#endif
