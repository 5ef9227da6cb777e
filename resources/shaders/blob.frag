in vec2 place;
uniform float strength;
out vec4 fragment;

void main()
{
    float inside = max(1.0 - dot(place, place), 0.0);
    fragment = vec4(0.0, 0.0, 0.0, strength * inside);
}
