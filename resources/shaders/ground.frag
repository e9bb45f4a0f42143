#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// A disc that fades into the background. Textures hold the tree's shadow from near parts (red) and far parts
// (green), each blurred as by the sun's disc, and how much of the sky the crown hides (blue).
#include "frame.glsl"
#include "lighting.glsl"
#include "background.glsl"

uniform sampler2D sharpShadow; // red
uniform sampler2D softShadow;  // green
uniform sampler2D skyShadow;   // blue

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

// Lines a metre apart, and stronger ones every ten.
float gridLines(vec2 world)
{
    vec2 pixel = fwidth(world);
    vec2 fine = 1.0 - smoothstep(0.2, 1.0, abs(fract(world + 0.5) - 0.5) / pixel);
    vec2 coarse = 1.0 - smoothstep(0.3, 1.2, 10.0 * abs(fract(0.1 * world + 0.5) - 0.5) / pixel);
    // Far away, lines would look like noise.
    vec2 apart = 1.0 - smoothstep(0.15, 0.5, pixel);
    return max(0.28 * max(fine.x * apart.x, fine.y * apart.y), 0.5 * max(coarse.x, coarse.y));
}

void main()
{
    float radius = length(groundPlace);
    if (radius >= 1.0)
        discard;
    vec2 world = groundPlace * frame.ground.w;
    vec2 at = 0.5 + 0.5 * world / frame.groundShadow.x;
    float isShaded = all(lessThan(abs(at - 0.5), vec2(0.5))) ? 1.0 : 0.0;
    // Surroundings reflect some of the sun's light into the shadow.
    float shade = isShaded * 0.88 * frame.sunDirection.w * (1.0 - (1.0 - texture(sharpShadow, at).r) * (1.0 - texture(softShadow, at).g));

    // Each trunk darkens the ground around its foot.
    float contact = 0.0;
    for (int i = 0; i < int(frame.foot.w); ++i) {
        vec3 foot = frame.feet[i].xyz;
        float away = max(length(world - foot.xy) - foot.z, 0.0) / foot.z;
        contact = max(contact, 0.75 * exp(-1.1 * away) + 0.25 * exp(-0.3 * away));
    }
    float sky = (1.0 - 0.5 * isShaded * texture(skyShadow, at).b) * (1.0 - 0.8 * contact);
    float sun = frame.sunDirection.y * (1.0 - shade);

    float fade = 1.0 - smoothstep(0.12, 1.0, radius);
    float opacity = fade * smoothstep(-0.02, 0.1, frame.eye.y / max(length(frame.eye.xyz), 1e-3));
    vec4 ground = vec4(0.0);
    if (frame.backgroundInner.w > 1.5) {
        // Before a background that the user has chosen, or on the paper of the light studio, only the shadow
        // on the ground shows: how much darker the ground would be.
        vec3 open = frame.sunColour.rgb * frame.sunDirection.y + frame.skyColour.rgb;
        vec3 left = frame.sunColour.rgb * sun + frame.skyColour.rgb * sky;
        float dark = 1.0 - pow(dot(left, vec3(1.0)) / dot(open, vec3(1.0)), 1.0 / 2.2);
        ground = vec4(vec3(0.0), dark * opacity);
    } else {
        // Like a pool of light on the floor of a studio.
        // Far away, grains would look like noise.
        vec2 pixel = fwidth(world);
        float near = 1.0 - smoothstep(0.05, 0.2, max(pixel.x, pixel.y));
        float texture = 1.0 + near * (0.08 * smoothGrain(world * 5.0) - 0.04);
        vec3 light = frame.ground.rgb * texture * (frame.sunColour.rgb * sun + frame.skyColour.rgb * sky);
        ground = vec4((developed(light) + dithering()) * opacity, opacity);
    }
    ground *= frame.foot.y;
    float lines = frame.foot.z * gridLines(world) * opacity;
    vec3 tone = vec3(dot(frame.backgroundInner.rgb, vec3(0.3, 0.6, 0.1)) > 0.5 ? 0.1 : 0.85);
    colour = ground * (1.0 - lines) + vec4(tone, 1.0) * lines;
}
