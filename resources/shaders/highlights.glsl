// Prepended to all shaders, before the lights: what smooth surfaces mirror.
#ifdef HIGHLIGHTS
uniform vec4 viewer;      // where one looks from; 0 in w: the direction towards there
uniform float highlights; // strength
uniform vec3 mirroredZenith;
uniform vec3 mirroredHorizon;
uniform vec3 mirroredGround;

// A place of a surface.
struct Mirror
{
    vec3 towardsEye;  // unit
    vec3 atFront;     // share of light that is mirrored, seen from the front
    float atEdge;     // and from the side
    float exponent;   // how narrow highlights are
    float smoothness; // 0..1
    float metal;      // share of its own colour that it has from what it mirrors alone
};

// Roughness to exponent: B. Walter et al., Microfacet Models for Refraction, 2007. What is rough
// mirrors nothing: its colour was chosen with that in it.
Mirror mirrorOf(vec3 world, vec2 roughnessAndMetallic, vec3 base)
{
    Mirror mirror;
    float wide = max(roughnessAndMetallic.x * roughnessAndMetallic.x, 0.05);
    float smoothly = 1.0 - roughnessAndMetallic.x;
    mirror.towardsEye = normalize(viewer.xyz - world * viewer.w);
    mirror.exponent = 2.0 / (wide * wide) - 2.0;
    mirror.smoothness = smoothly * smoothly;
    mirror.metal = roughnessAndMetallic.y * (1.0 - wide);
    mirror.atFront = mix(vec3(0.04), base, roughnessAndMetallic.y) * (1.0 - wide);
    mirror.atEdge = smoothly;
    return mirror;
}

// C. Schlick, 1994; rough surfaces mirror less of it from the side.
vec3 mirroredShare(Mirror mirror, float cosine)
{
    float beside = 1.0 - clamp(cosine, 0.0, 1.0);
    float squared = beside * beside;
    return mix(mirror.atFront, max(vec3(mirror.atEdge), mirror.atFront), squared * squared * beside);
}

// Of a light in that direction, of its colour. J. Blinn, 1977, of the same energy at every width.
vec3 glintOf(Mirror mirror, vec3 normal, vec3 towardsLight)
{
    float facing = max(dot(normal, towardsLight), 0.0);
    vec3 between = normalize(towardsLight + mirror.towardsEye);
    float narrow = pow(max(dot(normal, between), 1e-4), mirror.exponent);
    return mirroredShare(mirror, dot(between, towardsLight)) *
           ((mirror.exponent + 8.0) / 8.0 * narrow * facing);
}

// Of the sky and the ground as they are drawn.
vec3 mirroredSky(Mirror mirror, vec3 normal)
{
    vec3 way = reflect(-mirror.towardsEye, normal);
    float up = clamp(way.y * 1.6, 0.0, 1.0);
    float blur = 0.02 + 0.5 * (1.0 - mirror.atEdge);
    vec3 seen = mix(mirroredGround, mix(mirroredHorizon, mirroredZenith, up * (2.0 - up)),
                    smoothstep(-blur, blur, way.y));
    return seen * mirroredShare(mirror, abs(dot(normal, mirror.towardsEye))) *
           mix(mirror.smoothness, 1.0, mirror.metal);
}

// What is left of a colour that a surface has by itself.
float ownColor(Mirror mirror)
{
    return 1.0 - mirror.metal * min(highlights, 1.0);
}

// With what it mirrors; what is seen through mirrors as much as what is not.
vec3 withMirrored(vec4 surface, vec3 mirrored)
{
#ifdef BLENDED
    mirrored /= max(surface.a, 0.1);
#endif
    return surface.rgb + mirrored;
}
#endif
