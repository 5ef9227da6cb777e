// How much light the air of a cone sends to the eye, summed up on the way through it, as far as that
// is seen. The air is densest in the middle; looked at across, the sum is 2 (1 - u²) at the share u of
// the radius (an Abel transform of the density), times how the light thins out.
in vec3 at; // on the shell
uniform vec3 beamColor; // at a tenth of the way
uniform vec3 lamp;
uniform vec3 axis; // from what it lights to the lamp
uniform vec3 eye;
uniform vec3 forward;
uniform float reach;
uniform float slope;
uniform bool isPerspective;
#ifdef CLIPPED
uniform sampler2D depths;
uniform vec4 unproject; // what depth is in metres; see DepthCopy.h
#endif
#ifdef CUT
uniform mat4 lightMap;
uniform sampler2DShadow lightShadowMap;
uniform vec2 corner; // of this part of the picture
uniform float turn;  // of the places, another one for each picture that ripens
#endif
out vec4 fragment;

const float kFar = 1e6;
const float kNarrowest = 0.04; // share of the way from which on the cone has a width

// Metres along the way to where it leaves the cone, or to where it came in; and 1 where the shell is
// met there, so that it is drawn there, too.
vec2 otherEnd(vec3 way)
{
    vec3 from = at - lamp;
    float square = 1.0 / (1.0 + slope * slope); // of the edge's cosine
    float fall = -dot(way, axis);
    float deep = -dot(from, axis);
    float curve = fall * fall - square;
    float end = -2.0 * (deep * fall - square * dot(from, way)) / (abs(curve) > 1e-6 ? curve : 1e-6);
    float cap = (reach - deep) / (abs(fall) > 1e-6 ? fall : 1e-6);
    bool isOpen = curve > 0.0 || deep + end * fall > reach;
    return isOpen ? vec2(cap, 0.0) : vec2(end, 1.0);
}

// Where it is seen: from the eye, or wherever a parallel picture begins, to what hides the rest.
vec2 seenPart(vec3 way)
{
    float first = isPerspective ? -distance(at, eye) : -kFar;
#ifdef CLIPPED
    float depth = texelFetch(depths, ivec2(gl_FragCoord.xy), 0).r;
    float away = isPerspective ? unproject.z / (depth + unproject.w) : unproject.z * depth + unproject.w;
    return vec2(first, (away - dot(at - eye, forward)) / dot(way, forward));
#else
    return vec2(first, kFar);
#endif
}

// Of a metre of air there, across the beam.
float airAt(vec3 place)
{
    vec3 from = place - lamp;
    float deep = -dot(from, axis);
    float share = clamp(deep / reach, 0.0, 1.0);
    float radius = slope * reach * max(share, kNarrowest);
    float inside = 1.0 - max(dot(from, from) - deep * deep, 0.0) / (radius * radius);
    float thin = 0.1 / (0.1 + share) - 0.0909 * share;
    return 1.2732395 * sqrt(max(inside, 0.0)) * thin / radius;
}

void main()
{
    vec3 way = isPerspective ? normalize(at - eye) : forward;
    vec2 end = otherEnd(way);
    vec2 seen = seenPart(way);
    float first = max(min(end.x, 0.0), seen.x);
    float last = min(max(end.x, 0.0), seen.y);
    float begun = 0.5;
#ifdef CUT
    // Turned from pixel to pixel, so that no edges are seen between the places; after J. Jimenez,
    // "Next generation post processing in Call of Duty", 2014.
    begun = fract(fract(52.9829189 * fract(dot(gl_FragCoord.xy + corner, vec2(0.06711056, 0.00583715)))) +
                  turn);
#endif
    float sum = 0.0;
    for (int i = 0; i < PLACES; ++i) {
        vec3 place = at + way * mix(first, last, (float(i) + begun) / float(PLACES));
        float air = airAt(place);
#ifdef CUT
        vec4 onMap = lightMap * vec4(place, 1.0);
        air *= textureLod(lightShadowMap, onMap.xyz / onMap.w, 0.0);
#endif
        sum += air;
    }
    sum *= max(last - first, 0.0) / float(PLACES);
    // Who looks along it looks through much of it; a picture is not to go white of that.
    sum *= length(cross(way, axis));
    // Where the way meets the shell twice, both places are drawn.
    bool isTwice = end.y > 0.0 && end.x > seen.x;
    fragment = vec4(toned(beamColor * (isTwice ? 0.5 * sum : sum)), 0.0);
}
