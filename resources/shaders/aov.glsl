// Prepended to fragment shaders of what is drawn for its places instead of its colours.
const float kAovThing = -1.0; // stage or ground; people have their row, what is drawn by nobody less
layout(location = 0) out vec4 aovPlace; // world; whose in w
layout(location = 1) out vec4 aovNormal;
#ifdef MOTION
layout(location = 2) out vec2 aovBefore; // the way to where the point was: pixels, right and up
uniform mat4 earlierViewProjection;
uniform vec2 pictureSize;
#endif

void writeAovs(vec3 place, float whose, vec3 n)
{
    aovPlace = vec4(place, whose);
    aovNormal = vec4(normalize(gl_FrontFacing ? n : -n), 1.0);
}

// As a surface that was elsewhere a moment before; all write it after the others.
void writeMotion(vec3 placeBefore)
{
#ifdef MOTION
    vec4 clip = earlierViewProjection * vec4(placeBefore, 1.0);
    vec2 pixel = (clip.xy / clip.w * 0.5 + 0.5) * pictureSize;
    aovBefore = clip.w > 0.0 ? pixel - gl_FragCoord.xy : vec2(0.0); // behind the camera: unknown
#endif
}
