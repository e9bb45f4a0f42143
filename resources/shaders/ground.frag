#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A disc that fades into the background, with the tree's blurred shadow (red) and how much of the sky its crown hides
// (green) in a texture.
#include "frame.glsl"
#include "lighting.glsl"
#include "background.glsl"

uniform sampler2D groundShadow;

in vec2 groundPlace;

out vec4 colour;

float grain(vec2 p)
{
    return fract(sin(dot(p, vec2(12.9898, 78.233))) * 43758.5453);
}

float smoothGrain(vec2 p)
{
    vec2 cell = floor(p);
    vec2 t = smoothstep(0.0, 1.0, p - cell);
    return mix(mix(grain(cell), grain(cell + vec2(1.0, 0.0)), t.x),
               mix(grain(cell + vec2(0.0, 1.0)), grain(cell + vec2(1.0, 1.0)), t.x), t.y);
}

void main()
{
    float radius = length(groundPlace);
    if (radius >= 1.0)
        discard;
    vec2 shade = texture(groundShadow, 0.5 + 0.5 * groundPlace).rg;
    vec2 world = groundPlace * frame.ground.w;
    float texture = mix(1.0, 0.86 + 0.28 * smoothGrain(world * 9.0) * smoothGrain(world * 2.3 + 7.0), 0.4);

    float sun = frame.sunDirection.y * (1.0 - shade.r * frame.sunDirection.w);
    float sky = 1.0 - 0.6 * shade.g;
    vec3 light = frame.ground.rgb * texture * (frame.sunColour.rgb * sun + frame.skyColour.rgb * sky);
    // Like a pool of light on a studio's floor.
    float fade = 1.0 - smoothstep(0.12, 1.0, radius);
    float seenFromAbove = smoothstep(-0.02, 0.1, frame.eye.y / max(length(frame.eye.xyz), 1e-3));
    float opacity = fade * seenFromAbove;
    if (frame.backgroundInner.w > 2.5) {
        // Without a background only the shadow is left of the ground.
        float dark = clamp(0.75 * shade.r * frame.sunDirection.w + 0.5 * shade.g, 0.0, 1.0);
        colour = vec4(vec3(0.0), dark * opacity);
    } else {
        colour = vec4((developed(light) + dithering()) * opacity, opacity);
    }
}
