in vec4 color;
#ifdef CARTOON
in float level;
#endif
#if defined(HAZY) && !defined(LOW_HAZE)
in float hazed;
#endif
#ifdef SHADOWED
in vec4 shadowed;
#endif
#if defined(LIGHTS) || defined(LOW_HAZE) || defined(HIGHLIGHTS)
in vec3 worldPlace;
#endif
#if defined(LIGHTS) || defined(HIGHLIGHTS)
in vec3 surface;
in vec3 worldNormal;
#endif
#ifdef TEXTURED
in vec2 textureUv;
in vec3 glow;
uniform sampler2D image;
#endif
#ifdef GLOWING
in vec2 glowUv;
uniform sampler2D glowImage;
#endif
#ifdef HIGHLIGHTS
uniform vec2 gloss; // roughness, metallic
#endif
uniform float alphaCutoff;
#ifdef HIGHLIGHTS
uniform vec3 sunDirection; // towards the sun, unit
uniform vec3 sunColor;
#endif
out vec4 fragment;

void main()
{
    vec4 result = color;
#ifdef TEXTURED
    vec4 texel = texture(image, textureUv);
#endif
#ifdef CARTOON
    float share = level;
#endif
#ifdef SHADOWED
    float dark = sunHidden(shadowed);
    vec3 left = shadowedLight(shadowed, dark);
    result.rgb *= left;
#ifdef CARTOON
    share *= luminanceOf(left);
#endif
#endif
#ifdef HIGHLIGHTS
    vec3 n = normalize(worldNormal);
#ifdef TEXTURED
    Mirror mirror = mirrorOf(worldPlace, gloss, surface * texel.rgb);
#else
    Mirror mirror = mirrorOf(worldPlace, gloss, surface);
#endif
    vec3 mirrored = sunColor * glintOf(mirror, n, sunDirection);
#ifdef SHADOWED
    mirrored *= 1.0 - dark;
#endif
    mirrored += mirroredSky(mirror, n);
#endif
#ifdef LIGHTS
#ifdef HIGHLIGHTS
    vec3 others = lightsAt(worldPlace, n, mirror, mirrored);
#else
    vec3 others = lightsAt(worldPlace, normalize(worldNormal));
#endif
    result.rgb += surface * others;
#ifdef CARTOON
    share += luminanceOf(others) / fullLight;
#endif
#endif
#ifdef CARTOON
    result.rgb = cartoonOf(result.rgb, share);
#endif
#ifdef TEXTURED
#ifdef PAINTED
    result.a *= texel.a;
#else
    result *= texel;
#endif
#endif
#ifdef HIGHLIGHTS
    result.rgb *= ownColor(mirror);
    result.rgb = withMirrored(result, mirrored * highlights);
#endif
#ifdef TEXTURED
#ifdef GLOWING
    result.rgb += glow * texture(glowImage, glowUv).rgb;
#else
    result.rgb += glow;
#endif
#endif
#ifdef LOW_HAZE
    result.rgb = mix(result.rgb, hazeColor, hazeAt(worldPlace)); // walls have few corners
#elif defined(HAZY)
    result.rgb = mix(result.rgb, hazeColor, hazed);
#endif
    result.rgb = toned(result.rgb);
#ifdef CUTOUT
    if (result.a < alphaCutoff) {
        discard;
    }
#endif
#ifndef BLENDED
    result.a = 1.0;
#endif
    fragment = result;
}
