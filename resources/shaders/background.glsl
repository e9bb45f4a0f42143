// SPDX-License-Identifier: GPL-3.0-or-later
// The backdrop behind the tree, in displayed colours (sRGB).

float dithering()
{
    // Interleaved gradient noise (Jimenez 2014): hides the steps of dark gradients.
    return (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0;
}

vec3 backdrop(vec2 place)
{
    vec3 inner = frame.backgroundInner.rgb;
    vec3 outer = frame.backgroundOuter.rgb;
    if (frame.backgroundInner.w < 0.5 || frame.backgroundInner.w > 3.5) {
        vec2 offset = (place - vec2(0.5, 0.56)) * vec2(max(frame.viewSize.x * frame.viewSize.w, 1.0), 1.15);
        return mix(inner, outer, smoothstep(0.0, 1.0, length(offset) * 0.95));
    }
    if (frame.backgroundInner.w > 1.5)
        return mix(inner, outer, place.y);
    vec4 far = frame.inverseViewProjection * vec4(2.0 * place - 1.0, 1.0, 1.0);
    float height = normalize(far.xyz / far.w - frame.eye.xyz).y;
    vec3 sky = mix(inner, outer, smoothstep(0.0, 0.7, height));
    return mix(sky, inner * vec3(0.93, 0.925, 0.91), smoothstep(0.0, 0.25, -height));
}
