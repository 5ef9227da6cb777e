// The plane y = 0 around the camera.
uniform mat4 viewProjection;
uniform vec2 center;
uniform float halfSize;
out vec2 place; // metres from the camera's foot
#ifdef SHADOWED
out vec4 shadowed;
#endif

void main()
{
    place = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1) * halfSize;
    vec3 world = vec3(center.x + place.x, -0.005, center.y + place.y);
    gl_Position = viewProjection * vec4(world, 1.0);
#ifdef SHADOWED
    shadowed = shadowedOf(world, vec3(0.0, 1.0, 0.0), 0.0, vec3(0.0));
#endif
}
