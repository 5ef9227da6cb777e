// The air in a spotlight's cone: its shell, from both sides. Vertices are made here.
uniform mat4 viewProjection;
uniform vec3 lamp;
uniform vec3 axis;  // from what it lights to the lamp
uniform vec3 side;  // unit, across the axis
uniform float reach; // metres
uniform float slope; // radius per metre
uniform int sides;

out vec3 at;

void main()
{
    float angle = 6.2831853 * float(gl_VertexID / 2) / float(sides);
    vec3 out_ = cos(angle) * side + sin(angle) * cross(axis, side);
    float share = float(gl_VertexID & 1);
    at = lamp + reach * share * (slope * out_ - axis);
    gl_Position = viewProjection * vec4(at, 1.0);
}
