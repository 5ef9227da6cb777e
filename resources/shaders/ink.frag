// Lines around things and along their creases, from the depth alone. One over the distance is level in
// the picture on any flat surface: where it bends, there is an edge.
uniform sampler2D depths;
uniform ivec2 last; // pixel
uniform int width;  // half that of a line, pixels
uniform vec4 unproject; // as in occlusion.frag
uniform bool isPerspective;
uniform float pixelsPerMetre; // at a metre's distance, or everywhere
uniform vec3 inkColor;
out vec4 fragment;

// One over the metres; what is not there is endlessly far. Without perspective: the metres.
float nearness(ivec2 pixel)
{
    float depth = texelFetch(depths, clamp(pixel, ivec2(0), last), 0).r;
    return isPerspective ? (depth == 1.0 ? 0.0 : (depth + unproject.w) / unproject.z)
                         : unproject.z * depth + unproject.w;
}

void main()
{
    ivec2 at = ivec2(gl_FragCoord.xy);
    float here = nearness(at);
    float right = nearness(at + ivec2(width, 0));
    float left = nearness(at - ivec2(width, 0));
    float up = nearness(at + ivec2(0, width));
    float down = nearness(at - ivec2(0, width));
    float across = abs(right + left - 2.0 * here);
    float along = abs(up + down - 2.0 * here);
    float bend = max(across, along);
    // Where a floor is seen from low down, a step of nothing leaps far: what is much more than the
    // floor itself does is an edge.
    across *= step(5.0 * min(abs(right - here), abs(left - here)), across);
    along *= step(5.0 * min(abs(up - here), abs(down - here)), along);
    float leap = max(across, along);
    float nearest = max(max(max(right, left), max(up, down)), here);
    if (bend < 0.00001) {
        discard;
    }
    // As metres, and as how much the slope changes from pixel to pixel.
    float perMetre = isPerspective ? nearest * nearest : 1.0;
    float pixel = (isPerspective ? 1.0 / nearest : 1.0) / pixelsPerMetre * float(width);
    float outline = smoothstep(0.12, 0.3, leap / perMetre);
    float crease = smoothstep(0.9, 1.6, bend / perMetre / pixel) * (1.0 - smoothstep(0.006, 0.014, pixel));
    // Far away there would be nothing but lines.
    float seen = 1.0 - 0.55 * smoothstep(0.02, 0.08, pixel);
    float ink = max(outline * seen, 0.8 * crease);
    if (ink < 0.02) {
        discard;
    }
    fragment = vec4(inkColor, ink);
}
