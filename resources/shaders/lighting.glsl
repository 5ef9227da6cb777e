// Prepended to vertex shaders, and to those of fragments whose normal is their own. All colours are
// linear.
uniform vec3 sunDirection; // towards the sun, unit
uniform vec3 sunColor;
uniform vec3 skyColor;    // ambient from above
uniform vec3 bounceColor; // ambient from below

vec3 sunAt(vec3 normal)
{
#ifdef LIT
    return sunColor * max(dot(normal, sunDirection), 0.0);
#else
    return vec3(0.0);
#endif
}

vec3 skyAt(vec3 normal)
{
#ifdef LIT
    return mix(bounceColor, skyColor, normal.y * 0.5 + 0.5);
#else
    return vec3(1.0);
#endif
}

vec3 lightAt(vec3 normal)
{
    return sunAt(normal) + skyAt(normal);
}

// Share of a surface's light that is not the sun's.
float skyShare(vec3 normal, vec3 others)
{
    float sky = dot(skyAt(normal) + others, vec3(0.2126, 0.7152, 0.0722));
    float sun = dot(sunAt(normal), vec3(0.2126, 0.7152, 0.0722));
    return sky / max(sky + sun, 1e-4);
}

#ifdef CARTOON
uniform float fullLight; // luminance of all that sun and sky can give

float levelOf(vec3 light)
{
    return dot(light, vec3(0.2126, 0.7152, 0.0722)) / fullLight;
}
#endif

#ifdef SHADOWED
uniform mat4 mapFromWorld;   // 0..1 on the shadow map, and depth
uniform float shadowOffset;  // metres along the normal: surfaces do not shade themselves

// For shadowedLight: a place on the map, and the share of a surface's light that is not the sun's.
// One vector: a software rasteriser pays for each, whatever is in it. `others`: light from elsewhere.
vec4 shadowedOf(vec3 world, vec3 normal, float unlit, vec3 others)
{
    return vec4((mapFromWorld * vec4(world + normal * shadowOffset, 1.0)).xyz,
                mix(skyShare(normal, others), 1.0, unlit));
}
#endif
