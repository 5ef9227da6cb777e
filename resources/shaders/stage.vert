// Static geometry, lit per vertex: its light depends on the normal alone.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 uv;
layout(location = 3) in vec4 vertexColor;

uniform mat4 viewProjection;
uniform mat4 worldFromStage;
uniform vec4 baseColor;
uniform vec3 emissive;
uniform float unlit;
uniform vec3 uvRowU;
uniform vec3 uvRowV;

out vec4 color;
#ifdef TEXTURED
out vec2 textureUv;
out vec3 glow;
#endif
#ifdef GLOWING
uniform vec3 glowRowU;
uniform vec3 glowRowV;
out vec2 glowUv;
#endif

void main()
{
    gl_Position = viewProjection * (worldFromStage * vec4(position, 1.0));
    vec3 light = mix(lightAt(normalize(mat3(worldFromStage) * normal)), vec3(1.0), unlit);
    vec4 base = baseColor * vertexColor;
    color = vec4(base.rgb * light, base.a);
#ifdef TEXTURED
    textureUv = vec2(dot(uvRowU, vec3(uv, 1.0)), dot(uvRowV, vec3(uv, 1.0)));
    glow = emissive;
#else
    color.rgb += emissive;
#endif
#ifdef GLOWING
    glowUv = vec2(dot(glowRowU, vec3(uv, 1.0)), dot(glowRowV, vec3(uv, 1.0)));
#endif
}
