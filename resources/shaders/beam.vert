// The air in a spotlight's cone: its shell, from both sides. Vertices are made here.
uniform mat4 viewProjection;
uniform vec3 lamp;
uniform vec3 axis;  // from what it lights to the lamp
uniform vec3 side;  // unit, across the axis
uniform vec3 eye;
uniform float reach; // metres
uniform float slope; // radius per metre
uniform int sides;

out vec2 along; // share of the way from the lamp; how straight one looks through the air in it

void main()
{
    float angle = 6.2831853 * float(gl_VertexID / 2) / float(sides);
    vec3 out_ = cos(angle) * side + sin(angle) * cross(axis, side);
    float share = float(gl_VertexID & 1);
    vec3 world = lamp + reach * share * (slope * out_ - axis);
    gl_Position = viewProjection * vec4(world, 1.0);
    vec3 normal = normalize(out_ + slope * axis);
    // At the apex all normals meet: as it is halfway.
    vec3 seen = normalize(eye - (lamp + reach * 0.5 * (slope * out_ - axis)));
    along = vec2(share, dot(normal, share > 0.0 ? normalize(eye - world) : seen));
}
