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
