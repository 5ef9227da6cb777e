// Small discs and rings that lie in the scene.
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 positionAndRadius;
layout(location = 2) in vec4 markerColor;
layout(location = 3) in vec4 markerShape; // inner share, from and to in turns, least pixels

uniform mat4 viewProjection;
uniform float metresPerPixel; // times w
uniform float opacity;
uniform vec4 eye;   // towards the eye: eye.xyz - position * eye.w
uniform float pull; // metres that rings are taken for nearer, so that no ground swallows them
out vec2 place;
out vec4 color;
flat out vec3 shape;

void main()
{
    place = corner;
    color = vec4(markerColor.rgb, markerColor.a * opacity);
    shape = markerShape.xyz;
    vec4 center = viewProjection * vec4(positionAndRadius.xyz, 1.0);
    float radius = max(positionAndRadius.w, markerShape.w * metresPerPixel * max(center.w, 0.0));
    vec3 offset = vec3(corner.x, 0.0, corner.y) * radius;
    vec3 world = positionAndRadius.xyz + offset;
    gl_Position = viewProjection * vec4(world, 1.0);
    if (markerShape.x > 0.0) {
        vec3 toEye = eye.xyz - world * eye.w;
        float away = max(length(toEye), 0.0001);
        vec4 near = viewProjection * vec4(world + toEye / away * min(pull, away * 0.5), 1.0);
        if (gl_Position.w > 0.0 && near.w > 0.0) {
            gl_Position.z = near.z / near.w * gl_Position.w;
        }
    }
}
