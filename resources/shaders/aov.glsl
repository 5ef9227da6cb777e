// Prepended to fragment shaders of what is drawn for its places instead of its colours.
const float kAovThing = -1.0; // stage or ground; people have their row, what is drawn by nobody less
layout(location = 0) out vec4 aovPlace; // world; whose in w
layout(location = 1) out vec4 aovNormal;

void writeAovs(vec3 place, float whose, vec3 n)
{
    aovPlace = vec4(place, whose);
    aovNormal = vec4(normalize(gl_FrontFacing ? n : -n), 1.0);
}
