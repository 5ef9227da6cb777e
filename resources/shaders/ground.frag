in vec2 place;
uniform vec2 center;
uniform vec3 groundColor; // lit, linear
uniform vec3 horizon;
#if defined(LIGHTS) || defined(CARTOON)
uniform vec3 groundBase; // unlit
#endif
#ifdef SHADOWED
in vec4 shadowed;
#endif
uniform float fadeDistance;
#ifndef AOV
out vec4 fragment;
#endif

#ifdef GRID
// Coverage of lines `spacing` metres apart, about one pixel wide, gone where they would flicker.
float lines(vec2 metres, float spacing)
{
    vec2 cell = metres / spacing;
    vec2 width = fwidth(cell);
    vec2 gap = abs(fract(cell - 0.5) - 0.5) / max(width, vec2(1e-6));
    vec2 shown = (1.0 - min(gap, 1.0)) * clamp(1.0 - width * 3.0, 0.0, 1.0);
    return max(shown.x, shown.y);
}
#endif

void main()
{
#ifdef AOV
    vec3 onGround = vec3(center.x + place.x, 0.0, center.y + place.y);
    writeAovs(onGround, kAovThing, vec3(0.0, gl_FrontFacing ? 1.0 : -1.0, 0.0));
    writeMotion(onGround);
#else
    vec3 result = groundColor;
#ifdef SHADOWED
    result *= shadowedLight(shadowed, sunHidden(shadowed));
#endif
#ifdef LIGHTS
    result += groundBase * lightsAt(vec3(center.x + place.x, 0.0, center.y + place.y), vec3(0.0, 1.0, 0.0));
#endif
#ifdef CARTOON
    result = cartoonOf(result, luminanceOf(result) / max(luminanceOf(groundBase), 0.001) / fullLight);
#endif
#ifdef GRID
    vec2 metres = place + center;
    result *= 1.0 - 0.16 * lines(metres, 1.0) - 0.22 * lines(metres, 10.0);
#endif
#ifdef HAZY
    result = mix(result, hazeColor, hazeAt(vec3(center.x + place.x, 0.0, center.y + place.y)));
#endif
    float far = clamp(length(place) / fadeDistance, 0.0, 1.0);
    fragment = vec4(toned(mix(result, horizon, far * far * (3.0 - 2.0 * far))), 1.0);
#endif
}
