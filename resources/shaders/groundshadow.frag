#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// Where the sun is hidden from the ground (red), and where something stands right above it (green).
uniform sampler2DShadow shadowMap;
uniform sampler2D coverage;
uniform mat4 shadowFromWorld;
uniform mat4 coverageFromWorld;
uniform float radius; // of the ground, m

in vec2 place;

out vec4 colour;

void main()
{
    vec2 ground = (2.0 * place - 1.0) * radius;
    vec4 world = vec4(ground.x, 0.0, ground.y, 1.0);
    vec3 sunPlace = (shadowFromWorld * world).xyz;
    vec2 abovePlace = (coverageFromWorld * world).xy;
    bool outside = any(lessThan(abovePlace, vec2(0.0))) || any(greaterThan(abovePlace, vec2(1.0)));
    colour = vec4(1.0 - texture(shadowMap, vec3(sunPlace.xy, min(sunPlace.z, 0.9999))),
                  outside ? 0.0 : texture(coverage, abovePlace).r, 0.0, 1.0);
}
