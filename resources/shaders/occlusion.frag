// How much of the sky is hidden by what is near, from the depth alone; after M. McGuire, M. Mara,
// D. Luebke, "Scalable Ambient Obscurance", 2012. Variants: SPREAD blurs, APPLIED darkens the
// picture.
in vec2 place;
#ifdef APPLIED
uniform sampler2D occlusion;
uniform float strength;
#elif defined(SPREAD)
uniform sampler2D occlusion; // openness, depth as a share of the farthest
uniform ivec2 spread;        // the way
uniform ivec2 last;          // pixel
#else
uniform sampler2D depths;
uniform vec4 unproject; // half the width and height at a metre, and what depth is in metres
uniform vec2 axis;      // where the camera looks, beside the middle
uniform bool isPerspective;
uniform int coarseness;        // pixels to a texel of what is found
uniform float radius;         // metres
uniform float pixelsPerMetre; // at a metre's distance, or everywhere
uniform vec2 texel;           // share of the picture that a pixel is
uniform ivec2 last;           // pixel
#endif
out vec4 fragment;

#if !defined(APPLIED) && !defined(SPREAD)
const float kFarthest = 200.0; // metres
#ifdef QUICK
const int kTaps = 5;
#else
const int kTaps = 8;
#endif
const float kTurns = 5.0; // of the spiral

vec3 viewAt(ivec2 pixel)
{
    ivec2 within = clamp(pixel, ivec2(0), last);
    float depth = texelFetch(depths, within, 0).r;
    float away = isPerspective ? unproject.z / (depth + unproject.w) : unproject.z * depth + unproject.w;
    vec2 where = (vec2(within) * 2.0 + 1.0) * texel - 1.0 - axis;
    return vec3(where * unproject.xy * (isPerspective ? away : 1.0), -away);
}
#endif

void main()
{
#ifdef APPLIED
    fragment = vec4(vec3(mix(1.0, texture(occlusion, place).r, strength)), 1.0);
#elif defined(SPREAD)
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec2 here = texelFetch(occlusion, at, 0).rg;
    float allowed = 1.0 / (0.002 + 0.03 * here.g);
    float sum = here.r;
    float weights = 1.0;
    for (int i = -2; i < 1; ++i) { // as wide as the pattern of the taps
        ivec2 beside = clamp(at + spread * (i < 0 ? i : 1), ivec2(0), last);
        vec2 other = texelFetch(occlusion, beside, 0).rg;
        float weight = max(0.0, 1.0 - abs(other.g - here.g) * allowed);
        sum += other.r * weight;
        weights += weight;
    }
    fragment = vec4(sum / weights, here.g, 0.0, 1.0);
#else
    ivec2 at = ivec2(gl_FragCoord.xy) * coarseness + coarseness / 2;
    if (texelFetch(depths, min(at, last), 0).r == 1.0) { // nothing is there
        fragment = vec4(1.0);
        return;
    }
    vec3 here = viewAt(at);
    // The smaller of the steps to both sides: at an edge the other one leads to another surface.
    vec3 right = viewAt(at + ivec2(1, 0)) - here;
    vec3 left = here - viewAt(at - ivec2(1, 0));
    vec3 up = viewAt(at + ivec2(0, 1)) - here;
    vec3 down = here - viewAt(at - ivec2(0, 1));
    vec3 normal = normalize(cross(abs(right.z) < abs(left.z) ? right : left,
                                  abs(up.z) < abs(down.z) ? up : down));
    float away = -here.z;
    float pixels = min(radius * pixelsPerMetre / (isPerspective ? away : 1.0), 160.0);
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    // All sixteen of a square of four by four are different, and neighbours much.
    int both = cell.x ^ cell.y;
    int order = (both & 1) << 3 | (cell.y & 1) << 2 | (both & 2) | cell.y >> 1;
    float turn = float(order) * (6.2831853 / 16.0);
    float sum = 0.0;
    for (int i = 0; i < kTaps; ++i) {
        float share = (float(i) + 0.5) / float(kTaps);
        float angle = share * 6.2831853 * kTurns + turn;
        vec3 way = viewAt(at + ivec2(vec2(cos(angle), sin(angle)) * (share * pixels))) - here;
        float square = dot(way, way);
        float towards = dot(way, normal) - 0.01 - 0.002 * max(away, 0.0);
        float near = max(radius * radius - square, 0.0) / (radius * radius);
        sum += near * near * max(towards, 0.0) * inversesqrt(square + 0.0001);
    }
    float open = pixels > 1.5 ? max(0.0, 1.0 - sum * (9.0 / float(kTaps))) : 1.0;
    fragment = vec4(open, min(away / kFarthest, 1.0), 0.0, 1.0);
#endif
}
