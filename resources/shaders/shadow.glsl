// Prepended to fragment shaders of what shadows fall on.
#ifdef SHADOWED
uniform sampler2DShadow shadowMap;
uniform vec2 shadowSpread; // half the width of a soft edge, on the map
uniform float shadowStrength;
uniform vec3 shadowTint; // of what the sky alone lights, against what both do

// How much of the sun does not get there.
float sunHidden(vec4 place)
{
#if defined(TAPS4) || defined(TAPS8)
    // A turned square of taps, each of which blends four texels.
    vec2 a = shadowSpread * vec2(0.92, 0.38);
    vec2 b = shadowSpread * vec2(-0.38, 0.92);
    float seen = texture(shadowMap, vec3(place.xy + a, place.z)) +
                 texture(shadowMap, vec3(place.xy - a, place.z)) +
                 texture(shadowMap, vec3(place.xy + b, place.z)) +
                 texture(shadowMap, vec3(place.xy - b, place.z));
#ifdef TAPS8
    vec2 c = (a + b) * 0.5;
    vec2 d = (a - b) * 0.5;
    seen += texture(shadowMap, vec3(place.xy + c, place.z)) +
            texture(shadowMap, vec3(place.xy - c, place.z)) +
            texture(shadowMap, vec3(place.xy + d, place.z)) +
            texture(shadowMap, vec3(place.xy - d, place.z));
    seen *= 0.5;
#endif
    seen *= 0.25;
#else
    float seen = texture(shadowMap, place.xyz);
#endif
    return shadowStrength * (1.0 - seen);
}

// What is left of the full light; see shadowedOf in lighting.glsl.
vec3 shadowedLight(vec4 place, float dark)
{
    return mix(vec3(1.0), place.w * mix(vec3(1.0), shadowTint, 1.0 - place.w), dark);
}
#endif
