// Dark at its rims, so that it is seen on any ground.
in vec4 color;
in float across;
in float halfWidth;
uniform float rim;
out vec4 fragment;

void main()
{
    float inner = clamp((halfWidth - abs(across)) / max(rim, 0.01), 0.0, 1.0);
    fragment = vec4(color.rgb * smoothstep(0.5, 1.0, inner), color.a * smoothstep(0.0, 0.5, inner));
}
