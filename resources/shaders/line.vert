#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
// One segment of a line, as an instance of a strip of four corners that is as wide as the line.
#include "frame.glsl"

layout(location = 0) in vec3 from;
layout(location = 1) in vec3 to;
layout(location = 2) in float path; // px of line before the segment

uniform float width; // px
uniform vec2 overlaySize;

out float across; // px from the middle
out float along;  // px from the line's beginning

void main()
{
    vec4 a = frame.viewProjection * vec4(from, 1.0);
    vec4 b = frame.viewProjection * vec4(to, 1.0);
    // Points behind the camera have no place on the screen: the segment begins in front of it.
    const float nearest = 1e-3;
    if (a.w < nearest && b.w < nearest) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        across = 0.0;
        along = 0.0;
        return;
    }
    if (a.w < nearest)
        a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    if (b.w < nearest)
        b = mix(b, a, (nearest - b.w) / (a.w - b.w));
    vec2 direction = (b.xy / b.w - a.xy / a.w) * overlaySize * 0.5;
    float extent = length(direction);
    direction = extent > 1e-4 ? direction / extent : vec2(1.0, 0.0);
    float side = float(gl_VertexID & 1) * 2.0 - 1.0;
    bool atEnd = gl_VertexID >= 2;
    vec4 corner = atEnd ? b : a;
    across = side * (0.5 * width + 1.0);
    along = path + (atEnd ? extent : 0.0);
    corner.xy += vec2(-direction.y, direction.x) * across * 2.0 / overlaySize * corner.w;
    gl_Position = corner;
}
