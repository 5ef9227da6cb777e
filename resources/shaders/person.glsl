// Prepended to shaders that draw people: what their surface is made of and how it is lit. CARRIED: from
// the vertices to the fragments; or, of cards, from one function to the other.
uniform usamplerBuffer appearance; // per row: 4 tints | 4 tints | choices choices parts radius+modes
uniform samplerBuffer materials;  // per slot and choice, see below
uniform int choicesPerSlot;
uniform uint tintableSlots; // bit per slot
#ifdef PAINTED
uniform vec3 paint; // of everybody, whatever he is made of
#endif

const uint kRowMask = 0x00FFFFFFu;
const uint kSelectedBit = 0x80000000u;
const uint kHoveredBit = 0x40000000u;
const uint kNoPart = 255u;
const uint kModesMask = 255u; // in the lowest bits of the radius: slots whose colour is replaced

#ifdef IMPOSTOR
#define CARRIED
#define CARRIED_FLAT
#else
#define CARRIED out
#define CARRIED_FLAT flat out
#endif
#ifdef HAZY
CARRIED float hazed; // share that the air hides
#endif
#ifdef CARTOON
CARRIED float level; // of light, as a share of all there can be
#endif
CARRIED vec4 color; // lit base colour; alpha, or who is highlighted where that is 1
#ifdef SHADOWED
CARRIED vec4 shadowed;
#endif
#ifdef TEXTURED
CARRIED vec3 textureUv; // and the layer: one interpolated vector less
#endif
#ifdef TINT_IN_TEXTURE
CARRIED vec3 maskedTint;
#endif
#ifdef CUTOUT
CARRIED_FLAT vec2 cutoffAndHighlight;
#endif
#ifdef SEPARATE_MASK
CARRIED_FLAT float maskLayer;
#endif
#ifdef SPECIAL
CARRIED vec3 emissive;
#endif
#ifdef HIGHLIGHTS
CARRIED vec4 mirrored; // w: the sun's share of it
#endif
#if defined(REPLACED) && defined(TEXTURED)
CARRIED vec4 replacement; // times the luminance drawn so far; strength in w
const float kDarkest = 0.01; // black takes a colour too
#endif
#ifdef GLOWING
CARRIED vec3 glowUv; // and the layer
#endif

vec3 octahedral(uint code)
{
    vec2 square = vec2(float(code & 255u), float(code >> 8)) * (1.0 / 127.0) - 1.0;
    vec3 n = vec3(square, 1.0 - abs(square.x) - abs(square.y));
    float fold = max(-n.z, 0.0);
    n.xy += vec2(n.x >= 0.0 ? -fold : fold, n.y >= 0.0 ? -fold : fold);
    return n;
}

vec3 srgbToLinear(vec3 c)
{
    // Within 0.003 of the exact curve; tints need no more.
    return c * (c * (c * 0.305306011 + 0.682171111) + 0.012522878);
}

// The slot's tint: linear, strength in w.
vec4 tintOf(int texel, uint slot)
{
    if (slot >= 8u || (tintableSlots >> slot & 1u) == 0u) {
        return vec4(1.0, 1.0, 1.0, 0.0);
    }
    uint packedTint = texelFetch(appearance, texel + int(slot >> 2))[slot & 3u];
    vec4 tint = vec4(packedTint & 255u, packedTint >> 8 & 255u, packedTint >> 16 & 255u,
                     packedTint >> 24) * (1.0 / 255.0);
    return vec4(srgbToLinear(tint.rgb), tint.a);
}

float luminance(vec3 c)
{
    return dot(c, vec3(0.2126, 0.7152, 0.0722));
}

// Goes to the alpha of the picture, from which the outlines are drawn: nobody 1, else less than
// 0.6; neighbours mostly differ, so that a line shows between them. As in outline.frag.
float highlightOf(uint flags)
{
    if ((flags & kHoveredBit) != 0u) {
        return 8.0 / 255.0;
    }
    if ((flags & kSelectedBit) != 0u) {
        return float(32u + ((flags & kRowMask) * 2654435761u >> 29) * 16u) / 255.0;
    }
    return 1.0;
}

// Whether the individual shows that part of the template.
bool isShown(int row, uint part)
{
    return part == kNoPart || (texelFetch(appearance, row * 3 + 2).z >> part & 1u) != 0u;
}

// Fills what is carried for a place of the surface; false: nothing of it is drawn.
bool carry(uint rowAndFlags, uint slot, vec2 uv, vec4 vertexColor, vec3 world, vec3 n)
{
    int row = int(rowAndFlags & kRowMask);
    uvec4 choices = texelFetch(appearance, row * 3 + 2);
#ifdef HAZY
    hazed = hazeAt(world);
#endif
    int choice = slot < 8u ? int(choices[slot >> 2] >> ((slot & 3u) * 8u) & 255u) : 0;
    int material = (int(slot) * choicesPerSlot + min(choice, choicesPerSlot - 1)) * 7;
#ifdef BLENDED
    if (texelFetch(materials, material + 3).w == 0.0) { // another choice of the slot is
        return false;
    }
#endif
    vec4 base = texelFetch(materials, material) * vertexColor;
#ifdef PAINTED
    base.rgb = paint;
#endif
#ifdef OWN_COLOUR
    uint own = texelFetch(appearance, row * 3).x;
    base.rgb *= srgbToLinear(vec3(own & 255u, own >> 8 & 255u, own >> 16 & 255u) * (1.0 / 255.0));
#endif
#ifdef PAINTED
    vec4 slotTint = vec4(1.0, 1.0, 1.0, 0.0);
#else
    vec4 slotTint = tintOf(row * 3, slot);
#endif
    vec3 tint = mix(vec3(1.0), slotTint.rgb, slotTint.w);
    vec3 light = lightAt(n);
    vec3 others = vec3(0.0);
#ifdef HIGHLIGHTS
    vec2 gloss = vec2(texelFetch(materials, material + 5).w, texelFetch(materials, material + 6).w);
    Mirror mirror = mirrorOf(world, gloss, base.rgb * tint);
    vec3 fromSun = sunColor * glintOf(mirror, n, sunDirection);
    vec3 fromRest = mirroredSky(mirror, n);
#ifdef LIGHTS
    others = lightsAt(world, n, mirror, fromRest);
#endif
    mirrored = vec4(fromSun + fromRest, luminance(fromSun) / max(luminance(fromSun + fromRest), 1e-4));
    mirrored.rgb *= highlights;
#elif defined(LIGHTS)
    others = lightsAt(world, n);
#endif
    light += others;
#ifdef SHADOWED
    shadowed = shadowedOf(world, n, 0.0, others);
#endif
#if defined(TEXTURED) || defined(SPECIAL) || defined(CUTOUT)
    vec4 properties = texelFetch(materials, material + 1); // layer, mask layer, cutoff, unlit
#endif
#ifdef PAINTED
#if defined(TEXTURED) || defined(SPECIAL) || defined(CUTOUT)
    properties.w = 0.0;
#endif
#endif
#ifdef SPECIAL
    light = mix(light, vec3(1.0), properties.w);
#ifdef SHADOWED
    shadowed.w = mix(shadowed.w, 1.0, properties.w);
#endif
    vec4 emission = texelFetch(materials, material + 4); // layer in w
#ifdef PAINTED
    emission.rgb = vec3(0.0);
#endif
    emissive = emission.rgb;
#endif
#ifdef GLOWING
    glowUv = vec3(dot(texelFetch(materials, material + 5).xyz, vec3(uv, 1.0)),
                  dot(texelFetch(materials, material + 6).xyz, vec3(uv, 1.0)), emission.w);
#endif
#ifdef CARTOON
    level = levelOf(light);
#endif
#ifdef REPLACED
    // The tint itself, lighter and darker as the base colour is around its mean.
    bool isReplaced = slot < 8u && ((choices.w & kModesMask) >> slot & 1u) != 0u;
    float shade = max(max(vertexColor.r, vertexColor.g), vertexColor.b);
    tint = isReplaced ? vec3(1.0) : tint;
#ifdef TEXTURED
    float mean = texelFetch(materials, material + 2).w * luminance(vertexColor.rgb);
    replacement = vec4(slotTint.rgb * light * (shade / (mean * luminance(light) + kDarkest)),
                       isReplaced ? slotTint.w : 0.0);
#else
    base.rgb = mix(base.rgb, slotTint.rgb * shade, isReplaced ? slotTint.w : 0.0);
#endif
#endif
#ifdef TINT_IN_TEXTURE
    maskedTint = tint;
#else
    base.rgb *= tint;
#endif
#ifdef TEXTURED
#if defined(IMPOSTOR) && !defined(PICTURES_MOVED)
    textureUv = vec3(uv, properties.x);
#else
    vec3 rowU = texelFetch(materials, material + 2).xyz;
    vec3 rowV = texelFetch(materials, material + 3).xyz;
    textureUv = vec3(dot(rowU, vec3(uv, 1.0)), dot(rowV, vec3(uv, 1.0)), properties.x);
#endif
#endif
#ifdef SEPARATE_MASK
    maskLayer = properties.y;
#endif
#ifdef CUTOUT
    cutoffAndHighlight = vec2(properties.z, highlightOf(rowAndFlags));
#endif
#ifdef HIGHLIGHTS
    base.rgb *= ownColor(mirror);
#endif
#ifdef CUTOUT
    color = vec4(base.rgb * light, base.a);
#else
    color = vec4(base.rgb * light, highlightOf(rowAndFlags));
#endif
    return true;
}
