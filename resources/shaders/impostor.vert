// Two triangles per individual: a card, turned as the picture of the template that is nearest to how it
// is seen. Not one instance each, which takes some drivers as long as a hundred triangles.
uniform usamplerBuffer instances; // Instance, word by word: row and flags, phase, set
uniform int firstInstance;
uniform samplerBuffer placement; // per row: position cos | sin height girth lift
uniform usamplerBuffer cardSets; // SetRecord: low size | middle nearest depth sine | cosine width height layers | first card
uniform usamplerBuffer cards;    // CardRecord: what is shown, first texel, plane
uniform mat4 viewProjection;
uniform vec4 cardEye;         // where one looks from; 0 in w: the direction towards there
uniform float texelsPerPixel; // of pictures, a metre away
uniform float lastPictureLevel;

const int kAzimuths = 32;
const int kWords = 5; // of an Instance
const float kPi = 3.14159265;
const float kPerSlope = 1.0 / 8192.0;
const float kCasterMetres = 0.06;

out vec2 onCard;      // texels of what is shown
out vec3 onFront;     // the card moved to the nearest there is on it, world
flat out vec4 behind; // from there to the farthest, world; level of pictures in w
flat out uvec4 card;  // first texel, width and height, texels of a layer, row and flags
flat out vec4 shape;  // cos sin height girth

vec3 turned(vec3 p)
{
    return vec3(shape.x * p.x + shape.y * p.z, p.y, shape.x * p.z - shape.y * p.x);
}

void main()
{
    int at = (firstInstance + gl_VertexID / 6) * kWords;
    uint rowAndFlags = texelFetch(instances, at).x;
    int row = int(rowAndFlags & 0x00FFFFFFu);
    int record = int(texelFetch(instances, at + 2).x) * 4;
    vec4 extent = uintBitsToFloat(texelFetch(cardSets, record));
    vec4 inside = uintBitsToFloat(texelFetch(cardSets, record + 1));
    uvec4 texels = texelFetch(cardSets, record + 2);
    float cosine = uintBitsToFloat(texels.x);
    vec4 place = texelFetch(placement, row * 2);
    vec4 more = texelFetch(placement, row * 2 + 1);
    shape = vec4(place.w, more.xyz);
    vec3 scale = shape.wzw;
    vec3 middle = place.xyz + vec3(0.0, inside.x * scale.y, 0.0);
    vec3 away = cardEye.xyz - middle * cardEye.w;
    vec3 seen = vec3(shape.x * away.x - shape.y * away.z, away.y, shape.y * away.x + shape.x * away.z) / scale;
    int nearest = int(floor(atan(seen.x, seen.z) * (float(kAzimuths) * 0.5 / kPi) + 0.5)) & (kAzimuths - 1);
    float around = float(nearest) * (2.0 * kPi / float(kAzimuths));
    vec3 right = vec3(cos(around), 0.0, -sin(around));
    vec3 towards = vec3(-right.z * cosine, inside.w, right.x * cosine);
    vec3 up = cross(towards, right);
    int turn = gl_VertexID % 6;
    int which = turn < 3 ? turn : 6 - turn; // lower left, lower right, upper left; upper right
    uint firstCard = texelFetch(cardSets, record + 3).x;
    uint number = texelFetch(instances, at + 1).x * uint(kAzimuths) + uint(nearest);
    uvec4 cardRecord = texelFetch(cards, int(firstCard + number));
    vec4 shown = vec4(cardRecord.x & 255u, cardRecord.x >> 8 & 255u, cardRecord.x >> 16 & 255u, cardRecord.x >> 24);
    // Of the plane, metres towards the eye in the card's middle, and slopes to the right and up.
    vec3 plane = vec3(inside.y - inside.z * float(cardRecord.z & 65535u) * (1.0 / 65535.0),
                      float(int(cardRecord.z) >> 16) * kPerSlope, float(int(cardRecord.w << 16) >> 16) * kPerSlope);
    onCard = vec2((which & 1) == 0 ? 0.0 : shown.z - shown.x, which < 2 ? 0.0 : shown.w - shown.y);
    vec2 spot = extent.xy + (shown.xy + onCard) / vec2(texels.yz) * extent.zw;
    vec3 world = middle + turned((right * spot.x + up * spot.y) * scale);
    gl_Position = viewProjection * vec4(world, 1.0);
    onFront = world + turned(towards * inside.y * scale);
#ifdef CASTER
    // A picture from beside is a little elsewhere than what it shows, which is not to be in its own
    // shadow.
    onFront -= normalize(away) * kCasterMetres;
#endif
    // As deep as the plane that lies nearest to what the card shows. Fragments that said their own
    // depth could not be left out before they are worked on, where somebody nearer is.
    vec4 deep = viewProjection * vec4(world + turned(towards * (plane.x + dot(plane.yz, spot)) * scale), 1.0);
    gl_Position.z = deep.z / deep.w * gl_Position.w;
    behind = vec4(turned(towards * -inside.z * scale),
                  clamp(round(log2(texelsPerPixel * gl_Position.w / max(shape.w, 1e-4))), 0.0, lastPictureLevel));
    uvec2 size = uvec2(shown.zw - shown.xy);
    card = uvec4(cardRecord.y, size.x | size.y << 16, texels.w > 1u ? size.x * size.y : 0u, rowAndFlags);
}
