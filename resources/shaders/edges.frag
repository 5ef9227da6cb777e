// Smooth edges of a finished picture, after T. Lottes, FXAA (NVIDIA, 2009): an edge is followed both
// ways to where it ends, and the colour is taken from as far across it as the line it stands for
// crosses the pixel. First with MARKED, which only says where there are edges.
uniform sampler2D picture; // encoded, as it is seen
uniform vec2 texel;        // of a pixel
out vec4 fragment;

const float kLeast = 0.06;       // a difference in brightness below which nothing is an edge
const float kLeastShare = 0.125; // and as a share of the brightest
const float kThin = 0.6;         // of things a pixel wide, how much is blended

float brightness(vec2 pixels)
{
    return dot(textureLod(picture, (gl_FragCoord.xy + pixels) * texel, 0.0).rgb,
               vec3(0.299, 0.587, 0.114));
}

#ifdef MARKED
void main()
{
    float here = brightness(vec2(0.0));
    float up = brightness(vec2(0.0, 1.0));
    float down = brightness(vec2(0.0, -1.0));
    float right = brightness(vec2(1.0, 0.0));
    float left = brightness(vec2(-1.0, 0.0));
    float most = max(max(max(up, down), max(left, right)), here);
    float least = min(min(min(up, down), min(left, right)), here);
    if (most - least < max(kLeast, most * kLeastShare)) {
        discard;
    }
    fragment = vec4(0.0);
}
#else
const int kSteps = 6;
const float kReach[kSteps] = float[](1.0, 2.0, 3.0, 5.0, 8.0, 12.0); // pixels along the edge

// How far an edge goes on: pixels, and how the brightness there differs from the edge's own.
vec2 follow(vec2 border, vec2 along, float own, float limit)
{
    float away = 0.0;
    float difference = 0.0;
    bool isOver = false;
    for (int i = 0; i < kSteps; ++i) {
        float there = brightness(border + along * kReach[i]) - own;
        difference = isOver ? difference : there;
        away = isOver ? away : kReach[i];
        isOver = isOver || abs(there) >= limit;
    }
    return vec2(away, difference);
}

void main()
{
    float here = brightness(vec2(0.0));
    float up = brightness(vec2(0.0, 1.0));
    float down = brightness(vec2(0.0, -1.0));
    float right = brightness(vec2(1.0, 0.0));
    float left = brightness(vec2(-1.0, 0.0));
    float upRight = brightness(vec2(1.0, 1.0));
    float upLeft = brightness(vec2(-1.0, 1.0));
    float downRight = brightness(vec2(1.0, -1.0));
    float downLeft = brightness(vec2(-1.0, -1.0));
    float most = max(max(max(up, down), max(left, right)), here);
    float least = min(min(min(up, down), min(left, right)), here);
    float range = most - least;
    float acrossRows = abs(upLeft + downLeft - 2.0 * left) + 2.0 * abs(up + down - 2.0 * here) +
                       abs(upRight + downRight - 2.0 * right);
    float acrossColumns = abs(upLeft + upRight - 2.0 * up) + 2.0 * abs(left + right - 2.0 * here) +
                          abs(downLeft + downRight - 2.0 * down);
    bool isLevel = acrossRows >= acrossColumns;
    float low = isLevel ? down : left;
    float high = isLevel ? up : right;
    bool isHigh = abs(high - here) >= abs(low - here);
    vec2 across = (isLevel ? vec2(0.0, 1.0) : vec2(1.0, 0.0)) * (isHigh ? 1.0 : -1.0);
    vec2 along = isLevel ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    float own = 0.5 * ((isHigh ? high : low) + here);
    float limit = 0.25 * max(abs(high - here), abs(low - here));
    vec2 border = across * 0.5;
    vec2 before = follow(border, -along, own, limit);
    vec2 after = follow(border, along, own, limit);
    vec2 nearer = before.x < after.x ? before : after;
    // Only where the line, at its nearer end, goes over to this pixel's side.
    bool isCrossed = (here < own) != (nearer.y < 0.0);
    float shift = isCrossed ? 0.5 - nearer.x / (before.x + after.x) : 0.0;
    float around = (2.0 * (up + down + left + right) + upLeft + upRight + downLeft + downRight) / 12.0;
    float thin = smoothstep(0.0, 1.0, min(1.0, abs(around - here) / range));
    shift = max(shift, thin * thin * kThin);
    // For targets on which nothing could be marked. Without a discard, the marks spare the whole way.
    shift = range < max(kLeast, most * kLeastShare) ? 0.0 : shift;
    fragment = vec4(textureLod(picture, (gl_FragCoord.xy + across * shift) * texel, 0.0).rgb, 1.0);
}
#endif
