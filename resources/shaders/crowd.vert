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
uniform mat4 viewProjection;
uniform uint verticesPerKeyframe;

#ifdef AOV
out vec3 aovWorld;
out vec3 aovFacing;
flat out float aovRow;
#ifdef MOTION
uniform usamplerBuffer earlier; // per row: EarlierRecord
out vec3 aovWorldBefore;
#endif
#endif

#ifdef MOTION
vec3 pointOf(uint keyframe, uint box)
{
    uvec4 corner = texelFetch(keyframes, int(keyframe * verticesPerKeyframe + source));
    return texelFetch(clipBoxes, int(box) * 2).xyz +
           vec3(corner.xyz) * texelFetch(clipBoxes, int(box) * 2 + 1).xyz;
}

// As main() places the vertex now.
vec3 worldBefore(int row)
{
    vec4 place = uintBitsToFloat(texelFetch(earlier, row * 3));
    vec4 shape = uintBitsToFloat(texelFetch(earlier, row * 3 + 1));
    uvec4 shown = texelFetch(earlier, row * 3 + 2);
    vec3 point = mix(pointOf(shown.x, shown.z & 65535u), pointOf(shown.y, shown.z >> 16),
                     uintBitsToFloat(shown.w)) * shape.zyz;
    vec2 turn = vec2(place.w, shape.x);
    return place.xyz + vec3(turn.x * point.x + turn.y * point.z, point.y,
                            turn.x * point.z - turn.y * point.x);
}
#endif

void main()
{
    int row = int(instance.x & kRowMask);
    if (!isShown(row, slotAndPart.y)) {
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
#ifdef AOV
    aovWorld = world;
    aovFacing = n;
    aovRow = float(row);
#ifdef MOTION
    aovWorldBefore = worldBefore(row);
#endif
#endif

#if defined(CASTER) && !defined(CUTOUT)
    return;
#endif

    if (!carry(instance.x, slotAndPart.x, uv, vertexColor, world, n)) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
    }
}
