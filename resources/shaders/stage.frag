in vec4 color;
#ifdef SHADOWED
in vec4 shadowed;
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
#ifdef SHADOWED
    result.rgb *= shadowedLight(shadowed);
#endif
#ifdef TEXTURED
    result *= texture(image, textureUv);
#ifdef GLOWING
    result.rgb += glow * texture(glowImage, glowUv).rgb;
#else
    result.rgb += glow;
#endif
#endif
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
