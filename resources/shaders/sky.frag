in vec3 direction;
uniform vec3 zenith;
uniform vec3 horizon;
out vec4 fragment;

void main()
{
    float up = clamp(direction.y * inversesqrt(dot(direction, direction)) * 1.6, 0.0, 1.0);
    fragment = vec4(toned(mix(horizon, zenith, up * (2.0 - up))), 1.0);
}
