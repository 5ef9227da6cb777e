// A soft disc on the ground under each individual; vertices on a unit circle.
layout(location = 0) in vec2 corner;
layout(location = 4) in uvec4 instance;

uniform samplerBuffer placement;
uniform usamplerBuffer appearance;
uniform mat4 viewProjection;

out vec2 place;

void main()
{
    int row = int(instance.x & 0x00FFFFFFu);
    vec3 position = texelFetch(placement, row * 2).xyz;
    float lift = texelFetch(placement, row * 2 + 1).w;
    float radius = uintBitsToFloat(texelFetch(appearance, row * 3 + 2).w);
    place = corner;
    gl_Position = viewProjection * vec4(position.x + corner.x * radius, position.y - lift + 0.015,
                                        position.z + corner.y * radius, 1.0);
}
