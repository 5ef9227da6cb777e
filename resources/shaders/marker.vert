// Small discs that lie in the scene.
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 positionAndRadius;
layout(location = 2) in vec4 markerColor;

uniform mat4 viewProjection;
out vec2 place;
out vec4 color;

void main()
{
    place = corner;
    color = markerColor;
    vec3 offset = vec3(corner.x, 0.0, corner.y) * positionAndRadius.w;
    gl_Position = viewProjection * vec4(positionAndRadius.xyz + offset, 1.0);
}
