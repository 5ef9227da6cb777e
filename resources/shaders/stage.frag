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
#if defined(LIGHTS) || defined(LOW_HAZE) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
in vec3 worldPlace;
#endif
#if defined(LIGHTS) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
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
#if defined(HIGHLIGHTS) && !defined(RELIEF)
uniform vec3 sunDirection; // towards the sun, unit
uniform vec3 sunColor;
#endif
#ifdef RELIEF
in vec2 reliefUv;
uniform sampler2D reliefImage;
uniform float reliefScale;

// The normal that a normal map makes of one, in the frame that its coordinates span there: C. Schüler,
// Normal mapping without precomputed tangents, 2013. Rows of a picture go down, its y goes up.
vec3 relieved(vec3 n)
{
    vec3 right = dFdx(worldPlace);
    vec3 up = dFdy(worldPlace);
    vec2 uvRight = dFdx(reliefUv);
    vec2 uvUp = dFdy(reliefUv);
    vec3 acrossRight = cross(n, right);
    vec3 acrossUp = cross(up, n);
    vec3 alongU = acrossUp * uvRight.x + acrossRight * uvUp.x;
    vec3 alongV = acrossUp * uvRight.y + acrossRight * uvUp.y;
    float longest = max(dot(alongU, alongU), dot(alongV, alongV));
    if (longest <= 0.0) {
        return n; // it has no coordinates
    }
    vec3 own = texture(reliefImage, reliefUv).xyz * (255.0 / 127.0) - 128.0 / 127.0;
    own.xy *= reliefScale * inversesqrt(longest);
    return normalize(alongU * own.x - alongV * own.y + n * max(own.z, 0.0) + n * 1e-4);
}
#endif
#ifndef AOV
out vec4 fragment;
#endif

void main()
{
    vec4 result = color;
#ifdef TEXTURED
    vec4 texel = texture(image, textureUv);
#endif
#ifdef CARTOON
    float share = level;
#endif
#if defined(LIGHTS) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
    vec3 n = normalize(worldNormal);
#endif
#ifdef RELIEF
    n = relieved(n);
    result.rgb = surface * lightAt(n);
#endif
#ifdef SHADOWED
    vec4 shade = shadowed;
#ifdef RELIEF
    shade.w = skyShare(n, vec3(0.0));
#endif
    float dark = sunHidden(shade);
    vec3 left = shadowedLight(shade, dark);
    result.rgb *= left;
#ifdef CARTOON
    share *= luminanceOf(left);
#endif
#endif
#ifdef HIGHLIGHTS
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
    vec3 others = lightsAt(worldPlace, n);
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
#ifdef AOV
    writeAovs(worldPlace, kAovThing, n);
    writeMotion(worldPlace);
#else
    fragment = result;
#endif
}
