// SPDX-License-Identifier: GPL-3.0-or-later
// Each leaf is an instance of one card, whose x and z are in widths and y in lengths of the leaf.

layout(location = 0) in vec3 cardPosition;
layout(location = 1) in vec3 cardNormal;
layout(location = 2) in vec4 cardTangent;
layout(location = 3) in vec2 cardUv;
layout(location = 4) in vec4 leafPlace;    // where the petiole begins; w: length, m
layout(location = 5) in vec4 leafRotation; // quaternion x, y, z, w
layout(location = 6) in vec3 leafLook;     // width, m; shift of the hue, rad; brightness

vec3 turned(vec3 v)
{
    vec3 twice = 2.0 * cross(leafRotation.xyz, v);
    return v + leafRotation.w * twice + cross(leafRotation.xyz, twice);
}

// A random number, 0...1, for each leaf.
float lotOfLeaf()
{
    return fract(sin(dot(leafPlace.xyz + leafRotation.xyz, vec3(157.3, 241.9, 87.1))) * 43758.5453);
}

vec3 leafPosition()
{
    return leafPlace.xyz + turned(cardPosition * vec3(leafLook.x, leafPlace.w, leafLook.x));
}
