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

// The share of the sun's light that reaches bark. @surface: normal of the wood, @normal: of its relief.
float sunOnBark(vec3 position, vec3 surface, vec3 normal)
{
    float facing = dot(surface, frame.sunDirection.xyz);
    // A step along the normal keeps the surface out of its own shadow.
    vec3 probe = position + surface * frame.lightOrigin.w * (1.5 + 2.0 * (1.0 - max(facing, 0.0)));
    return sunSeen(probe) * max(dot(normal, frame.sunDirection.xyz), 0.0) * smoothstep(-0.2, 0.1, facing);
}

// The colour that the foot of the trunk has from splashed soil.
vec3 soiled(vec3 position)
{
    return mix(vec3(0.62, 0.58, 0.5), vec3(1.0), smoothstep(-0.5, 4.0, position.y / frame.foot.x));
}

vec3 rimLight(vec3 normal, vec3 toEye)
{
    float rim = 1.0 - max(dot(normal, toEye), 0.0);
    return frame.rimColour.rgb * (rim * rim * rim);
}
