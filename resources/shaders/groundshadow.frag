#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// The places of the ground where near (red) or far (green) parts of the tree hide the sun, and where a part
// of the tree stands directly above (blue).
uniform sampler2D shadowMap;
uniform sampler2D coverage;
uniform mat4 shadowFromWorld;
uniform mat4 coverageFromWorld;
uniform float radius; // of the ground, m
uniform float near;   // difference of depth in the shadow map up to which a caster is near

in vec2 place;

out vec4 colour;

void main()
{
    vec2 ground = (2.0 * place - 1.0) * radius;
    vec4 world = vec4(ground.x, 0.0, ground.y, 1.0);
    vec3 sunPlace = (shadowFromWorld * world).xyz;
    vec2 abovePlace = (coverageFromWorld * world).xy;
    bool outside = any(lessThan(abovePlace, vec2(0.0))) || any(greaterThan(abovePlace, vec2(1.0)));
    float above = sunPlace.z - texture(shadowMap, sunPlace.xy).r;
    float hidden = texture(shadowMap, sunPlace.xy).r < min(sunPlace.z, 0.9999) ? 1.0 : 0.0;
    float far = smoothstep(0.5 * near, 1.5 * near, above);
    colour = vec4(hidden * (1.0 - far), hidden * far, outside ? 0.0 : texture(coverage, abovePlace).r, 1.0);
}
