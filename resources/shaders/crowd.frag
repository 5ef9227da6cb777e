#ifndef IMPOSTOR // those have them from person.glsl
in vec4 color;
#ifdef AOV
in vec3 aovWorld;
in vec3 aovFacing;
#ifdef MOTION
in vec3 aovWorldBefore;
#endif
flat in float aovRow;
#endif
#ifdef CARTOON
in float level;
#endif
#ifdef HAZY
in float hazed;
#endif
#ifdef SHADOWED
in vec4 shadowed;
#endif
#ifdef TEXTURED
in vec3 textureUv;
#endif
#ifdef GLOWING
in vec3 glowUv;
#endif
#ifdef TINT_IN_TEXTURE
in vec3 maskedTint;
#endif
#ifdef CUTOUT
flat in vec2 cutoffAndHighlight;
#endif
#ifdef SEPARATE_MASK
flat in float maskLayer;
#endif
#ifdef SPECIAL
in vec3 emissive;
#endif
#ifdef HIGHLIGHTS
in vec4 mirrored; // w: the sun's share of it
#endif
#if defined(REPLACED) && defined(TEXTURED)
in vec4 replacement;
const float kDarkest = 0.01; // as in crowd.vert
#endif
#endif
#if (defined(TEXTURED) || defined(GLOWING)) && !defined(IMPOSTOR)
uniform sampler2DArray images; // alpha holds the tint mask where the material is opaque
vec4 sampled(vec3 at)
{
    return texture(images, at);
}

vec3 srgbToLinear(vec3 c)
{
    // Within 0.003 of the exact curve.
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}
#endif
#ifdef OPACITY
uniform float opacity;
#endif

#ifndef AOV
out vec4 fragment;
#endif

#ifdef BLENDED
const float kClear = 1.0 / 255.0;
#endif

void main()
{
#ifdef IMPOSTOR
    carryTexel();
#endif
#if defined(CASTER) && !defined(CUTOUT)
    return;
#endif
    vec4 result = color;
#ifdef SHADOWED
    float dark = sunHidden(shadowed);
    vec3 left = shadowedLight(shadowed, dark);
    result.rgb *= left;
#endif
#ifdef CARTOON
#ifdef SHADOWED
    result.rgb = cartoonOf(result.rgb, level * luminanceOf(left));
#else
    result.rgb = cartoonOf(result.rgb, level);
#endif
#endif
#ifdef TEXTURED
    vec4 texel = sampled(textureUv);
#ifndef PAINTED
    result.rgb *= srgbToLinear(texel.rgb);
#endif
#ifdef SEPARATE_MASK
    result.a *= texel.a;
    float mask = maskLayer < 0.0 ? 1.0 : sampled(vec3(textureUv.xy, maskLayer)).r;
#else
    float mask = texel.a;
#endif
#ifdef TINT_IN_TEXTURE
    result.rgb *= mix(vec3(1.0), maskedTint, mask);
#endif
#ifdef REPLACED
    float brightness = dot(result.rgb, vec3(0.2126, 0.7152, 0.0722));
    result.rgb = mix(result.rgb, replacement.rgb * (brightness + kDarkest), replacement.w * mask);
#endif
#endif
#ifdef HIGHLIGHTS
#ifdef SHADOWED
    result.rgb = withMirrored(result, mirrored.rgb * (1.0 - mirrored.w * dark));
#else
    result.rgb = withMirrored(result, mirrored.rgb);
#endif
#endif
#ifdef GLOWING
    result.rgb += emissive * srgbToLinear(sampled(glowUv).rgb);
#elif defined(SPECIAL)
    result.rgb += emissive;
#endif
#ifdef HAZY
    result.rgb = mix(result.rgb, hazeColor, hazed);
#endif
    result.rgb = toned(result.rgb);
#ifdef BLENDED
    if (result.a >= cutoffAndHighlight.x || result.a < kClear) { // the solid rest was drawn before
        discard;
    }
#elif defined(CUTOUT) && defined(AOV)
    if (result.a < min(cutoffAndHighlight.x, 0.5)) { // what is blended counts where it is seen
        discard;
    }
#elif defined(CUTOUT)
    if (result.a < cutoffAndHighlight.x) {
        discard;
    }
    result.a = cutoffAndHighlight.y;
#endif
#ifdef OPACITY
    result.a *= opacity;
#endif
#ifdef AOV
    writeAovs(aovWorld, aovRow, aovFacing);
#ifdef MOTION
    writeMotion(aovWorldBefore);
#endif
#else
    fragment = result;
#endif
}
