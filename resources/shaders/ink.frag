// Lines around things and along their creases, from the depth alone. One over the distance is level in
// the picture on any flat surface: where it bends, there is an edge.
uniform sampler2D depths;
uniform ivec2 last; // pixel
uniform int width;  // half that of a line, pixels
uniform vec4 unproject; // as in occlusion.frag
uniform bool isPerspective;
uniform float pixelsPerMetre; // at a metre's distance, or everywhere
uniform vec3 inkColor;
// With (1, x, y) of a pixel: one over the metres to the ground there; 0: there is none.
uniform vec3 groundPlane;
out vec4 fragment;

// One over the metres; what is not there is endlessly far. Without perspective: the metres.
float nearness(ivec2 pixel)
{
    float depth = texelFetch(depths, clamp(pixel, ivec2(0), last), 0).r;
    return isPerspective ? (depth == 1.0 ? 0.0 : (depth + unproject.w) / unproject.z)
                         : unproject.z * depth + unproject.w;
}

bool isGroundOrSky(ivec2 pixel, float near)
{
    float ground = dot(groundPlane, vec3(1.0, vec2(pixel) + 0.5));
    // The ground lies a pixel's worth behind, so that floors on it win.
    return near == 0.0 || abs(near - ground) < 1.5 * length(groundPlane.yz) + 0.002 * near;
}

// The ground ends somewhere, but that is no edge.
bool isHorizon(ivec2 at, float right, float left, float up, float down, float here)
{
    return min(min(min(right, left), min(up, down)), here) == 0.0 && isGroundOrSky(at, here) &&
           isGroundOrSky(at + ivec2(width, 0), right) && isGroundOrSky(at - ivec2(width, 0), left) &&
           isGroundOrSky(at + ivec2(0, width), up) && isGroundOrSky(at - ivec2(0, width), down);
}

// Of a crack that is a pixel wide, as where surfaces of a model do not quite meet, what is beside it.
float closedNearness(ivec2 pixel)
{
    float here = nearness(pixel);
    float left = nearness(pixel - ivec2(1, 0));
    float right = nearness(pixel + ivec2(1, 0));
    float below = nearness(pixel - ivec2(0, 1));
    float above = nearness(pixel + ivec2(0, 1));
    float beside = isPerspective ? max(min(left, right), min(below, above))
                                 : min(max(left, right), max(below, above));
    float leap = isPerspective ? (beside - here) / (beside * beside) : here - beside;
    return leap > 0.1 ? beside : here;
}

// From one side to the other through the middle; what is before or behind both is no slope.
float slopeThrough(float before, float here, float after)
{
    float first = here - before;
    float second = after - here;
    return first * second > 0.0 ? min(abs(first), abs(second)) : 0.0;
}

// Where a floor is seen from low down, a step of nothing leaps far: an edge is where more leaps than
// that, of what is in front. How much that is, from how it goes on there.
float leastLeap(ivec2 at, float here, float right, float left, float up, float down)
{
    float nearer = isPerspective ? 1.0 : -1.0; // the larger, the nearer
    ivec2 front = at;
    float nearest = nearer * here;
    if (nearer * right > nearest) { front = at + ivec2(width, 0); nearest = nearer * right; }
    if (nearer * left > nearest) { front = at - ivec2(width, 0); nearest = nearer * left; }
    if (nearer * up > nearest) { front = at + ivec2(0, width); nearest = nearer * up; }
    if (nearer * down > nearest) { front = at - ivec2(0, width); nearest = nearer * down; }
    nearest *= nearer;
    float across = slopeThrough(nearness(front - ivec2(width, 0)), nearest,
                                nearness(front + ivec2(width, 0)));
    float along = slopeThrough(nearness(front - ivec2(0, width)), nearest,
                               nearness(front + ivec2(0, width)));
    return 5.0 * max(across, along);
}

// How much ink there is on a pixel with these around it, 0 to 1.
float inkAt(ivec2 at, float here, float right, float left, float up, float down, float least)
{
    float across = abs(right + left - 2.0 * here);
    float along = abs(up + down - 2.0 * here);
    // At the picture's border there is nothing to compare with.
    across = at.x < width || at.x > last.x - width ? 0.0 : across;
    along = at.y < width || at.y > last.y - width ? 0.0 : along;
    float bend = max(across, along);
    across *= step(least, across);
    along *= step(least, along);
    float leap = max(across, along);
    float nearest = max(max(max(right, left), max(up, down)), here);
    if (bend < 0.00001 || (isPerspective && isHorizon(at, right, left, up, down, here))) {
        return 0.0;
    }
    // As metres, and as how much the slope changes from pixel to pixel.
    float perMetre = isPerspective ? nearest * nearest : 1.0;
    float pixel = (isPerspective ? 1.0 / nearest : 1.0) / pixelsPerMetre * float(width);
    float outline = smoothstep(0.12, 0.3, leap / perMetre);
    float crease = smoothstep(0.9, 1.6, bend / perMetre / pixel) * (1.0 - smoothstep(0.006, 0.014, pixel));
    // Far away there would be nothing but lines.
    float seen = 1.0 - 0.55 * smoothstep(0.02, 0.08, pixel);
    return max(outline * seen, 0.8 * crease);
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    ivec2 aside = ivec2(width, 0);
    ivec2 above = ivec2(0, width);
    float here = nearness(at);
    float right = nearness(at + aside);
    float left = nearness(at - aside);
    float up = nearness(at + above);
    float down = nearness(at - above);
    float ink = inkAt(at, here, right, left, up, down, 0.0);
    if (ink < 0.02) {
        discard;
    }
    // Few pixels come as far as this, fewer farther.
    float least = leastLeap(at, here, right, left, up, down);
    ink = min(ink, inkAt(at, here, right, left, up, down, least));
    if (ink < 0.02) {
        discard;
    }
    ink = min(ink, inkAt(at, closedNearness(at), closedNearness(at + aside),
                         closedNearness(at - aside), closedNearness(at + above),
                         closedNearness(at - above), least));
    if (ink < 0.02) {
        discard;
    }
    fragment = vec4(inkColor, ink);
}
