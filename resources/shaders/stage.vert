// Static geometry. What sun and sky give depends on the normal alone and is had here; what lights of
// the scene give is for the fragments.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 vertexColor;

invariant gl_Position; // the depths that are drawn first are those of the surface

uniform mat4 viewProjection;
uniform mat4 worldFromStage;
uniform vec4 baseColor;
uniform vec3 emissive;
uniform float unlit;
#ifdef PAINTED
uniform vec3 paint; // of all stages, whatever they are made of
#endif
uniform vec3 uvRowU;
uniform vec3 uvRowV;

#if defined(HAZY) && !defined(LOW_HAZE)
out float hazed; // share that the air hides
#endif
#ifdef CARTOON
out float level; // of light, as a share of all there can be
#endif
out vec4 color;
#ifdef SHADOWED
out vec4 shadowed;
#endif
#if defined(LIGHTS) || defined(LOW_HAZE) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
out vec3 worldPlace;
#endif
#if defined(LIGHTS) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
out vec3 surface; // unlit
out vec3 worldNormal;
#endif
#ifdef TEXTURED
out vec2 textureUv;
out vec3 glow;
#endif
#ifdef GLOWING
uniform vec3 glowRowU;
uniform vec3 glowRowV;
out vec2 glowUv;
#endif
#ifdef RELIEF
uniform vec3 reliefRowU;
uniform vec3 reliefRowV;
out vec2 reliefUv;
#endif

void main()
{
    vec4 world = worldFromStage * vec4(position, 1.0);
    gl_Position = viewProjection * world;
#if defined(HAZY) && !defined(LOW_HAZE)
    hazed = hazeAt(world.xyz);
#endif
    vec3 n = normalize(mat3(worldFromStage) * normal);
    vec4 base = baseColor * vertexColor;
#ifdef PAINTED
    base.rgb = paint;
    float own = 0.0;
    vec3 glowing = vec3(0.0);
#else
    float own = unlit; // share of its colour that needs no light
    vec3 glowing = emissive;
#endif
    vec3 light = mix(lightAt(n), vec3(1.0), own);
#ifdef SHADOWED
    shadowed = shadowedOf(world.xyz, n, own, vec3(0.0));
#endif
#if defined(LIGHTS) || defined(LOW_HAZE) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
    worldPlace = world.xyz;
#endif
#if defined(LIGHTS) || defined(HIGHLIGHTS) || defined(RELIEF) || defined(AOV)
    surface = base.rgb * (1.0 - own);
    worldNormal = n;
#endif
#ifdef CARTOON
    level = levelOf(light);
#endif
    color = vec4(base.rgb * light, base.a);
#ifdef TEXTURED
    textureUv = vec2(dot(uvRowU, vec3(uv, 1.0)), dot(uvRowV, vec3(uv, 1.0)));
    glow = glowing;
#else
    color.rgb += glowing;
#endif
#ifdef RELIEF
    reliefUv = vec2(dot(reliefRowU, vec3(uv, 1.0)), dot(reliefRowV, vec3(uv, 1.0)));
#endif
#ifdef GLOWING
    glowUv = vec2(dot(glowRowU, vec3(uv, 1.0)), dot(glowRowV, vec3(uv, 1.0)));
#endif
}
