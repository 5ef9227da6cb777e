// A picture as it is, linear: into a sum of several, and out of it.
uniform sampler2D picture;
out vec4 fragment;

void main()
{
    fragment = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
}
