in vec2 place;
in vec4 color;
flat in vec3 shape; // inner share, from and to in turns
out vec4 fragment;

void main()
{
    float edge = dot(place, place);
    if (edge > 1.0 || edge < shape.x * shape.x) {
        discard;
    }
    if (shape.z - shape.y < 0.999) {
        float turn = atan(place.x, place.y) * 0.15915494 + 0.5;
        if (turn < shape.y || turn > shape.z) {
            discard;
        }
    }
    float dark = shape.x > 0.0 ? 0.86 : 0.64; // a ring keeps more of its colour
    fragment = vec4(color.rgb * (edge > dark ? 0.55 : 1.0), color.a);
}
