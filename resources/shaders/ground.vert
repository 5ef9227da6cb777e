// The plane y = 0 around the camera.
uniform mat4 viewProjection;
uniform vec2 center;
uniform float halfSize;
out vec2 place; // metres from the camera's foot

void main()
{
    place = vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID >> 1) * 2 - 1) * halfSize;
    gl_Position = viewProjection * vec4(center.x + place.x, -0.005, center.y + place.y, 1.0);
}
