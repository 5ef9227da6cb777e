in vec2 along;
uniform vec3 beamColor; // at a tenth of the way
out vec4 fragment;

void main()
{
    // The way through the air is short at the edge, and the light thins out with its distance.
    float depth = along.y * along.y;
    float thin = 0.1 / (0.1 + along.x) - 0.0909 * along.x;
    fragment = vec4(toned(beamColor * depth * thin), 0.0);
}
