// Prepended to all shaders: the air, and the lights that stand in the scene.
#ifdef HAZY
uniform vec3 eye;
uniform float hazePerMetre;
#ifdef LOW_HAZE
uniform float hazeHeight; // metres up to where it is thinner by e

// How dense it is on the way between two heights, on average: it thins exponentially.
float hazeBetween(float from, float to)
{
    vec2 at = max(vec2(from, to) / hazeHeight, -1.0);
    vec2 dense = exp(-at);
    float rise = at.y - at.x;
    return abs(rise) > 0.001 ? (dense.x - dense.y) / rise : dense.x;
}
#endif

// What the air hides of something there.
float hazeAt(vec3 world)
{
    float way = distance(world, eye);
#ifdef LOW_HAZE
    way *= hazeBetween(eye.y, world.y);
#endif
    return 1.0 - exp(-hazePerMetre * way);
}
#endif
#ifdef LIGHTS
// LIGHTS: their number, known when it is compiled, so that the loop is none.
uniform vec4 lightPlaces[LIGHTS]; // where they are; brightness per cosine within the edge of the cone
uniform vec4 lightAxes[LIGHTS];   // towards the lamp, 0 for all sides; cosine of the edge
uniform float lightSquares[LIGHTS]; // of the distance within which they get no brighter
uniform vec4 lightColors[LIGHTS]; // a metre away; how far from the surface its shadow is asked for there

#ifdef LIGHT_SHADOWS
// LIGHT_SHADOWS: so many of the first cast some, first SPOT_SHADOWS that have a cone, then those that
// shine to all sides, which have six maps each. They lie side by side on one.
uniform mat4 lightMaps[SPOT_SHADOWS + 6 * (LIGHT_SHADOWS - SPOT_SHADOWS)];
uniform sampler2DShadow lightShadowMap;
uniform float lightShadowSpread;

// On which of its maps a light sees what lies on this way from it.
int lightMap(int light, vec3 way)
{
#if LIGHT_SHADOWS > SPOT_SHADOWS
    if (light >= SPOT_SHADOWS) {
        vec3 far = abs(way);
        int axis = far.x >= far.y && far.x >= far.z ? 0 : far.y >= far.z ? 1 : 2;
        return SPOT_SHADOWS + 6 * (light - SPOT_SHADOWS) + 2 * axis + (way[axis] < 0.0 ? 1 : 0);
    }
#endif
    return light;
}

// The share of a light that gets there, so many metres away.
float lightLeft(int light, vec3 world, vec3 normal, float away)
{
    vec3 asked = world + normal * (lightColors[light].w * away);
    vec4 place = lightMaps[lightMap(light, asked - lightPlaces[light].xyz)] * vec4(asked, 1.0);
    vec3 at = place.xyz / place.w;
#ifdef LIGHT_TAPS4
    // A turned square of taps, each of which blends four texels.
    vec2 a = lightShadowSpread * vec2(0.92, 0.38);
    vec2 b = lightShadowSpread * vec2(-0.38, 0.92);
    return 0.25 * (textureLod(lightShadowMap, vec3(at.xy + a, at.z), 0.0) +
                   textureLod(lightShadowMap, vec3(at.xy - a, at.z), 0.0) +
                   textureLod(lightShadowMap, vec3(at.xy + b, at.z), 0.0) +
                   textureLod(lightShadowMap, vec3(at.xy - b, at.z), 0.0));
#else
    return textureLod(lightShadowMap, at, 0.0);
#endif
}
#endif

// `mirrored` takes what the surface mirrors of them on top.
vec3 lightsAt(vec3 world, vec3 normal
#ifdef HIGHLIGHTS
              , Mirror mirror, inout vec3 mirrored
#endif
)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 way = lightPlaces[i].xyz - world;
        float square = max(dot(way, way), 1e-6);
        float perSquare = 1.0 / max(square, lightSquares[i]);
        vec3 towards = way * inversesqrt(square);
        float cone = clamp((dot(towards, lightAxes[i].xyz) - lightAxes[i].w) * lightPlaces[i].w, 0.0, 1.0);
        float got = perSquare * cone * cone;
        float facing = max(dot(normal, towards), 0.0);
#ifdef LIGHT_SHADOWS
        if (i < LIGHT_SHADOWS && facing * got > 0.0) {
            got *= lightLeft(min(i, LIGHT_SHADOWS - 1), world, normal, sqrt(square));
        }
#endif
        sum += lightColors[i].rgb * (facing * got);
#ifdef HIGHLIGHTS
        mirrored += lightColors[i].rgb * got * glintOf(mirror, normal, towards);
#endif
    }
    return sum;
}
#endif
