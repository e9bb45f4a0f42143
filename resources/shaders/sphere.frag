#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "frame.glsl"
#include "overlaydepth.glsl"

uniform vec3 centre;
uniform float pixelSize; // of the overlay at distance 1, m
uniform float radius;
uniform float width; // px, of the outline
uniform vec4 tint; // w: opacity of the inside

in vec3 worldPosition;

out vec4 colour;

float depthOf(vec3 position)
{
    vec4 clip = frame.viewProjection * vec4(position, 1.0);
    return 0.5 + 0.5 * clip.z / clip.w;
}

void main()
{
    vec3 view = normalize(worldPosition - frame.eye.xyz);
    vec3 offset = centre - frame.eye.xyz;
    float ahead = dot(offset, view);
    float miss = length(offset - ahead * view); // distance of the ray from the middle
    float pixel = pixelSize * max(ahead, 1e-3);
    float inside = clamp((radius - miss) / pixel + 0.5, 0.0, 1.0);
    float outline = clamp(0.5 * width + 0.5 - abs(miss - radius) / pixel, 0.0, 1.0);
    float halfway = sqrt(max(radius * radius - miss * miss, 0.0));
    vec3 front = frame.eye.xyz + (ahead - halfway) * view;
    vec3 back = frame.eye.xyz + (ahead + halfway) * view;
    // Parts of the scene inside the ball are tinted more than those in front of it.
    float depth = texture(sceneDepth, (gl_FragCoord.xy - overlayOrigin) / overlaySize).r;
    float reached = depth < depthOf(front) ? 0.3 : 1.0;
    float within = depth >= depthOf(front) && depth < depthOf(back) ? 1.5 : 1.0;
    vec3 normal = normalize(front - centre);
    float lit = 0.75 + 0.35 * max(dot(normal, frame.sunDirection.xyz), 0.0);
    float edge = 0.55 + 0.9 * pow(clamp(miss / radius, 0.0, 1.0), 3.0);
    float fill = inside * tint.w * edge * reached * within;
    float line = outline * mix(0.45, 0.95, step(1.0, reached));
    colour = vec4(tint.rgb * lit * fill * (1.0 - line) + tint.rgb * line, fill * (1.0 - line) + line);
}
