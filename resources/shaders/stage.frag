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
#if defined(LIGHTS) || defined(LOW_HAZE)
in vec3 worldPlace;
#endif
#ifdef LIGHTS
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
uniform float alphaCutoff;
out vec4 fragment;

void main()
{
    vec4 result = color;
#ifdef CARTOON
    float share = level;
#endif
#ifdef SHADOWED
    vec3 left = shadowedLight(shadowed);
    result.rgb *= left;
#ifdef CARTOON
    share *= luminanceOf(left);
#endif
#endif
#ifdef LIGHTS
    vec3 others = lightsAt(worldPlace, normalize(worldNormal));
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
    result.a *= texture(image, textureUv).a;
#else
    result *= texture(image, textureUv);
#endif
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
