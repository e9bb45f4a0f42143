#version 330 core
// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlaydepth.glsl"

uniform float width; // px
uniform float dash;  // px, 0 = solid
uniform vec4 tint;
uniform float least; // Share of the opacity that stays behind the scene

in float across;
in float along;

out vec4 colour;

void main()
{
    float cover = clamp(0.5 * width + 0.5 - abs(across), 0.0, 1.0);
    if (dash > 0.0)
        cover *= clamp(0.5 * dash + 0.5 - abs(mod(along, 2.0 * dash) - dash), 0.0, 1.0);
    float opacity = tint.w * cover * max(least, nearness(gl_FragCoord.z));
    colour = vec4(tint.rgb * opacity, opacity);
}
