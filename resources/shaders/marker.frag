in vec2 place;
in vec4 color;
out vec4 fragment;

void main()
{
    float edge = dot(place, place);
    if (edge > 1.0) {
        discard;
    }
    fragment = vec4(color.rgb * (edge > 0.64 ? 0.55 : 1.0), color.a);
}
