// Prepended to fragment shaders of what has light: from a surface to the picture.
#ifdef HAZY
uniform vec3 hazeColor;
#endif
#ifdef TONED
uniform vec3 toneGain;
#endif
#ifdef FILMIC
// Fit of the ACES curve by K. Narkowicz, 2016; the factor keeps the middle grey where it was.
vec3 filmic(vec3 c)
{
    c *= 0.722;
    return clamp(c * (2.51 * c + 0.03) / (c * (2.43 * c + 0.59) + 0.14), 0.0, 1.0);
}
#endif

#ifdef CARTOON
#if !defined(RELIEF) && !defined(IMPOSTOR) // else it is there from lighting.glsl
uniform float fullLight; // luminance of all that sun and sky can give
#endif

float luminanceOf(vec3 c)
{
    return dot(c, vec3(0.2126, 0.7152, 0.0722));
}

// What a share of the full light becomes: two or three steps, and coarser ones where lights make more of it.
float stepped(float level)
{
    float more = 1.0 + 0.5 * min(floor(max(level - 1.0, 0.0) * 2.0 + 0.25), 2.0);
#ifdef TWO_TONES
    return (0.50 + 0.50 * smoothstep(0.46, 0.49, level)) * more;
#else
    return (0.42 + 0.26 * smoothstep(0.30, 0.33, level) + 0.32 * smoothstep(0.60, 0.63, level)) * more;
#endif
}

// A lit colour, with its share of the full light, in steps.
vec3 cartoonOf(vec3 lit, float level)
{
    return lit * (stepped(level) / max(level, 0.02));
}
#endif

vec3 toned(vec3 c)
{
#ifdef TONED
    c *= toneGain;
#ifdef FILMIC
    c = filmic(c);
#endif
#endif
    return c;
}
