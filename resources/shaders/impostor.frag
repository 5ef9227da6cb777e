// Of a card: what crowd.vert hands to crowd.frag, which comes after this, is made of a texel here.
in vec2 onCard;
in vec3 onFront;
flat in vec4 behind;
flat in uvec4 card;
flat in vec4 shape;

uniform usamplerBuffer cardTexels; // ImpostorTexel
#ifdef CASTER
uniform mat4 viewProjection;
#endif
#if defined(TEXTURED) || defined(GLOWING)
uniform sampler2DArray images; // alpha holds the tint mask where the material is opaque

// Neighbours on a card are none on the picture: how large it is seen is known beforehand.
vec4 sampled(vec3 at)
{
    int level = int(behind.w);
    vec2 size = vec2(textureSize(images, level).xy);
    return texelFetch(images, ivec3(ivec2(fract(at.xy) * size), int(at.z + 0.5)), level);
}
#endif

const uint kNoSlot = 63u;
const uint kNoPartOfCard = 63u;

uint slotOf(uint kind)
{
    return kind >> 8 & 63u;
}

// Nothing is drawn where nothing is.
void carryTexel()
{
    ivec2 size = ivec2(card.y & 65535u, card.y >> 16);
    ivec2 at = clamp(ivec2(onCard), ivec2(0), size - 1);
    int texel = int(card.x) + at.y * size.x + at.x;
    uvec2 found = texelFetch(cardTexels, texel).xy;
    if (slotOf(found.y) == kNoSlot) {
        discard;
    }
#ifdef PARTS
    uint part = found.y >> 14 & 63u;
    if (part != kNoPartOfCard && !isShown(int(card.w & kRowMask), part)) {
        found = texelFetch(cardTexels, texel + int(card.z)).xy;
        if (slotOf(found.y) == kNoSlot) {
            discard;
        }
    }
#endif
    vec3 world = onFront + behind.xyz * (float(found.y & 255u) * (1.0 / 255.0));
#ifdef CASTER
    // Into shadow maps as deep as it is: else arms and legs were in the shadow of the whole.
    vec4 place = viewProjection * vec4(world, 1.0);
    gl_FragDepth = clamp(place.z / place.w * 0.5 + 0.5, 0.0, 1.0);
    return;
#endif
    vec3 n = octahedral(found.x >> 16) * shape.zwz; // proportional to the inverse of the scale
    n = normalize(vec3(shape.x * n.x + shape.y * n.z, n.y, shape.x * n.z - shape.y * n.x));
    vec2 uv = (vec2(found.x & 255u, found.x >> 8 & 255u) + 0.5) * (1.0 / 256.0);
    vec3 root = vec3(found.y >> 20 & 15u, found.y >> 24 & 15u, found.y >> 28) * (1.0 / 15.0);
    carry(card.w, slotOf(found.y), uv, vec4(root * root, 1.0), world, n);
}

