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

// A pixel and its neighbours.
struct Cross
{
    float here, up, down, right, left;
    float range; // of all of them
    bool isEdge;
};

Cross crossHere()
{
    Cross c;
    c.here = brightness(vec2(0.0));
    c.up = brightness(vec2(0.0, 1.0));
    c.down = brightness(vec2(0.0, -1.0));
    c.right = brightness(vec2(1.0, 0.0));
    c.left = brightness(vec2(-1.0, 0.0));
    float most = max(max(max(c.up, c.down), max(c.left, c.right)), c.here);
    float least = min(min(min(c.up, c.down), min(c.left, c.right)), c.here);
    c.range = most - least;
    c.isEdge = c.range >= max(kLeast, most * kLeastShare);
    return c;
}

#ifdef MARKED
void main()
{
    if (!crossHere().isEdge) {
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
    Cross c = crossHere();
    float upRight = brightness(vec2(1.0, 1.0));
    float upLeft = brightness(vec2(-1.0, 1.0));
    float downRight = brightness(vec2(1.0, -1.0));
    float downLeft = brightness(vec2(-1.0, -1.0));
    float acrossRows = abs(upLeft + downLeft - 2.0 * c.left) + 2.0 * abs(c.up + c.down - 2.0 * c.here) +
                       abs(upRight + downRight - 2.0 * c.right);
    float acrossColumns = abs(upLeft + upRight - 2.0 * c.up) + 2.0 * abs(c.left + c.right - 2.0 * c.here) +
                          abs(downLeft + downRight - 2.0 * c.down);
    bool isLevel = acrossRows >= acrossColumns;
    float low = isLevel ? c.down : c.left;
    float high = isLevel ? c.up : c.right;
    bool isHigh = abs(high - c.here) >= abs(low - c.here);
    vec2 across = (isLevel ? vec2(0.0, 1.0) : vec2(1.0, 0.0)) * (isHigh ? 1.0 : -1.0);
    vec2 along = isLevel ? vec2(1.0, 0.0) : vec2(0.0, 1.0);
    float own = 0.5 * ((isHigh ? high : low) + c.here);
    float limit = 0.25 * max(abs(high - c.here), abs(low - c.here));
    vec2 border = across * 0.5;
    vec2 before = follow(border, -along, own, limit);
    vec2 after = follow(border, along, own, limit);
    vec2 nearer = before.x < after.x ? before : after;
    // Only where the line, at its nearer end, goes over to this pixel's side.
    bool isCrossed = (c.here < own) != (nearer.y < 0.0);
    float shift = isCrossed ? 0.5 - nearer.x / (before.x + after.x) : 0.0;
    float around = (2.0 * (c.up + c.down + c.left + c.right) + upLeft + upRight + downLeft + downRight) / 12.0;
    float thin = smoothstep(0.0, 1.0, min(1.0, abs(around - c.here) / c.range));
    shift = max(shift, thin * thin * kThin);
    // For targets on which nothing could be marked. Without a discard, the marks spare the whole way.
    shift = c.isEdge ? shift : 0.0;
    fragment = vec4(textureLod(picture, (gl_FragCoord.xy + across * shift) * texel, 0.0).rgb, 1.0);
}
#endif
