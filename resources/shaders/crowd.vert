// One individual per instance: two keyframes blended, then placed, tinted and lit per vertex.
layout(location = 0) in vec2 uv;
layout(location = 1) in vec4 vertexColor;
layout(location = 2) in uint source; // vertex within a keyframe
layout(location = 3) in uvec2 slotAndPart; // part 255: always shown
layout(location = 4) in uvec4 instance; // row and flags, keyframes A and B, clips A and B
layout(location = 5) in float keyframeBlend;

uniform usamplerBuffer keyframes; // PackedVertex: keyframe by keyframe
uniform samplerBuffer clipBoxes;  // per clip: low, size / 65535
uniform samplerBuffer placement;  // per row: position cos | sin height girth lift
uniform usamplerBuffer appearance; // per row: 4 tints | 4 tints | choices choices parts radius
uniform samplerBuffer materials;  // per slot and choice, see below
uniform mat4 viewProjection;
uniform uint verticesPerKeyframe;
uniform int choicesPerSlot;
uniform uint tintableSlots; // bit per slot
uniform vec4 selectedTint;  // linear, strength in w
uniform vec4 hoveredTint;

const uint kRowMask = 0x00FFFFFFu;
const uint kSelectedBit = 0x80000000u;
const uint kHoveredBit = 0x40000000u;
const uint kNoPart = 255u;

out vec4 color; // lit base colour, alpha
#ifdef TEXTURED
out vec3 textureUv; // and the layer: one interpolated vector less
#endif
#ifdef TINT_IN_TEXTURE
out vec3 maskedTint;
#endif
#ifdef CUTOUT
flat out float alphaCutoff;
#endif
#ifdef SEPARATE_MASK
flat out float maskLayer;
#endif
#ifdef SPECIAL
out vec3 emissive;
#endif
#ifdef OUTLINE
uniform vec2 outlineShift; // in normalised device coordinates
uniform vec3 viewForward;
const float kOutlineDepth = 0.5; // metres
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

// What the slot's tint multiplies the base colour by, inside its mask.
vec3 tintOf(int texel, uint slot)
{
    if (slot >= 8u || (tintableSlots >> slot & 1u) == 0u) {
        return vec3(1.0);
    }
    uint packedTint = texelFetch(appearance, texel + int(slot >> 2))[slot & 3u];
    vec4 tint = vec4(packedTint & 255u, packedTint >> 8 & 255u, packedTint >> 16 & 255u,
                     packedTint >> 24) * (1.0 / 255.0);
    return mix(vec3(1.0), srgbToLinear(tint.rgb), tint.a);
}

void main()
{
    int row = int(instance.x & kRowMask);
    uvec4 choices = texelFetch(appearance, row * 3 + 2);
    uint slot = slotAndPart.x;
    if (slotAndPart.y != kNoPart && (choices.z >> slotAndPart.y & 1u) == 0u) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        return;
    }
    uvec4 packedA = texelFetch(keyframes, int(instance.y * verticesPerKeyframe + source));
    uvec4 packedB = texelFetch(keyframes, int(instance.z * verticesPerKeyframe + source));
    int boxA = int(instance.w & 65535u) * 2;
    int boxB = int(instance.w >> 16) * 2;
    vec3 pointA = texelFetch(clipBoxes, boxA).xyz + vec3(packedA.xyz) * texelFetch(clipBoxes, boxA + 1).xyz;
    vec3 pointB = texelFetch(clipBoxes, boxB).xyz + vec3(packedB.xyz) * texelFetch(clipBoxes, boxB + 1).xyz;
    vec3 point = mix(pointA, pointB, keyframeBlend);
    vec3 n = mix(octahedral(packedA.w), octahedral(packedB.w), keyframeBlend);

    vec4 place = texelFetch(placement, row * 2);
    vec4 shape = texelFetch(placement, row * 2 + 1);
    vec2 turn = vec2(place.w, shape.x); // cos, sin
    point *= shape.zyz;
    n *= shape.yzy; // proportional to the inverse of the scale
    vec3 world = place.xyz + vec3(turn.x * point.x + turn.y * point.z, point.y,
                                  turn.x * point.z - turn.y * point.x);
    n = normalize(vec3(turn.x * n.x + turn.y * n.z, n.y, turn.x * n.z - turn.y * n.x));
    gl_Position = viewProjection * vec4(world, 1.0);
#ifdef OUTLINE
    // Drawn shifted to several sides, a little behind itself, so that only a rim shows.
    vec4 behind = viewProjection * vec4(world + viewForward * kOutlineDepth, 1.0);
    gl_Position.z = behind.z / behind.w * gl_Position.w;
    gl_Position.xy += outlineShift * gl_Position.w;
    color = vec4((instance.x & kSelectedBit) != 0u ? selectedTint.rgb : hoveredTint.rgb, 1.0);
    return;
#endif

    int choice = slot < 8u ? int(choices[slot >> 2] >> ((slot & 3u) * 8u) & 255u) : 0;
    int material = (int(slot) * choicesPerSlot + min(choice, choicesPerSlot - 1)) * 5;
    vec4 base = texelFetch(materials, material) * vertexColor;
    vec3 light = lightAt(n);
#if defined(TEXTURED) || defined(SPECIAL) || defined(CUTOUT)
    vec4 properties = texelFetch(materials, material + 1); // layer, mask layer, cutoff, unlit
#endif
#ifdef SPECIAL
    light = mix(light, vec3(1.0), properties.w);
    emissive = texelFetch(materials, material + 4).rgb;
#endif
    vec3 tint = tintOf(row * 3, slot);
#ifdef TINT_IN_TEXTURE
    maskedTint = tint;
#else
    base.rgb *= tint;
#endif
#ifdef TEXTURED
    vec3 rowU = texelFetch(materials, material + 2).xyz;
    vec3 rowV = texelFetch(materials, material + 3).xyz;
    textureUv = vec3(dot(rowU, vec3(uv, 1.0)), dot(rowV, vec3(uv, 1.0)), properties.x);
#endif
#ifdef SEPARATE_MASK
    maskLayer = properties.y;
#endif
#ifdef CUTOUT
    alphaCutoff = properties.z;
#endif
    color = vec4(base.rgb * light, base.a);
    if ((instance.x & kSelectedBit) != 0u) {
        color.rgb = mix(color.rgb, selectedTint.rgb, selectedTint.w);
    }
    if ((instance.x & kHoveredBit) != 0u) {
        color.rgb = mix(color.rgb, hoveredTint.rgb, hoveredTint.w);
    }
}
