// A line as a band of some pixels on screen, from one end to the other.
layout(location = 0) in vec2 corner; // across -1..1, along -1 or 1
layout(location = 1) in vec4 fromAndWidth;
layout(location = 2) in vec4 toAndWidth;
layout(location = 3) in vec4 ribbonColor;
uniform mat4 viewProjection;
uniform vec2 viewSize; // logical pixels
uniform float rim;     // logical pixels, dark, to either side
uniform float opacity;
out vec4 color;
out float across;   // logical pixels from the middle
out float halfWidth;

const float kNearest = 0.01; // of w: what is behind the eye is cut off

void main()
{
    vec4 from = viewProjection * vec4(fromAndWidth.xyz, 1.0);
    vec4 to = viewProjection * vec4(toAndWidth.xyz, 1.0);
    color = vec4(ribbonColor.rgb, ribbonColor.a * opacity);
    if (from.w < kNearest && to.w < kNearest) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        across = 0.0;
        halfWidth = 0.0;
        return;
    }
    if (from.w < kNearest) {
        from = mix(from, to, (kNearest - from.w) / (to.w - from.w));
    } else if (to.w < kNearest) {
        to = mix(to, from, (kNearest - to.w) / (from.w - to.w));
    }
    vec2 way = (to.xy / to.w - from.xy / from.w) * viewSize;
    vec2 aside = length(way) > 0.0001 ? normalize(vec2(-way.y, way.x)) : vec2(0.0, 1.0);
    bool isEnd = corner.y > 0.0;
    halfWidth = 0.5 * (isEnd ? toAndWidth.w : fromAndWidth.w) + rim;
    across = corner.x * halfWidth;
    vec4 at = isEnd ? to : from;
    gl_Position = vec4(at.xy + aside * across * 2.0 / viewSize * at.w, at.zw);
}
