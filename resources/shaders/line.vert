layout(location = 0) in vec3 position;
layout(location = 1) in vec4 lineColor;
uniform mat4 viewProjection;
uniform vec4 eye;   // towards the eye: eye.xyz - position * eye.w
uniform float pull; // metres nearer in depth, not in the picture
uniform float opacity;
out vec4 color;

void main()
{
    color = vec4(lineColor.rgb, lineColor.a * opacity);
    gl_Position = viewProjection * vec4(position, 1.0);
    vec3 toEye = eye.xyz - position * eye.w;
    float away = max(length(toEye), 0.0001);
    vec4 near = viewProjection * vec4(position + toEye / away * min(pull, away * 0.5), 1.0);
    if (gl_Position.w > 0.0 && near.w > 0.0) {
        gl_Position.z = near.z / near.w * gl_Position.w;
    }
}
