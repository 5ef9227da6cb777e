layout(location = 0) in vec3 position;
layout(location = 1) in vec4 lineColor;
uniform mat4 viewProjection;
uniform float opacity;
out vec4 color;

void main()
{
    color = vec4(lineColor.rgb, lineColor.a * opacity);
    gl_Position = viewProjection * vec4(position, 1.0);
}
