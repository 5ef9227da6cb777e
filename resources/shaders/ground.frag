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
// Coverage of lines one cell apart, about one pixel wide, gone where they would flicker; a pixel is
// `width` cells wide, and so many of it make a cell. The ground is often most of a picture: what lines
// of several distances share is reckoned once.
float lines(vec2 cell, vec2 width, vec2 perCell)
{
    vec2 gap = abs(cell - roundEven(cell)) * perCell;
    vec2 shown = (1.0 - min(gap, 1.0)) * max(1.0 - 3.0 * width, 0.0);
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
    vec2 width = max(fwidth(place), vec2(1e-6));
    vec2 perMetre = 1.0 / width;
    result *= 1.0 - 0.16 * lines(metres, width, perMetre) -
              0.22 * lines(0.1 * metres, 0.1 * width, 10.0 * perMetre);
#endif
#ifdef HAZY
    result = mix(result, hazeColor, hazeAt(vec3(center.x + place.x, 0.0, center.y + place.y)));
#endif
    float far = clamp(length(place) / fadeDistance, 0.0, 1.0);
    fragment = vec4(toned(mix(result, horizon, far * far * (3.0 - 2.0 * far))), 1.0);
#endif
}
