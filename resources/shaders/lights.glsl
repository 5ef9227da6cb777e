// Prepended to all shaders: the air, and the lights that stand in the scene.
#ifdef HAZY
uniform vec3 eye;
uniform float hazePerMetre;

// What the air hides of something there.
float hazeAt(vec3 world)
{
    return 1.0 - exp(-hazePerMetre * distance(world, eye));
}
#endif
#ifdef LIGHTS
// LIGHTS: their number, known when it is compiled, so that the loop is none.
uniform vec4 lightPlaces[LIGHTS]; // where they are; brightness per cosine within the edge of the cone
uniform vec4 lightAxes[LIGHTS];   // towards the lamp, 0 for all sides; cosine of the edge
uniform vec4 lightColors[LIGHTS]; // a metre away

vec3 lightsAt(vec3 world, vec3 normal)
{
    vec3 sum = vec3(0.0);
    for (int i = 0; i < LIGHTS; ++i) {
        vec3 way = lightPlaces[i].xyz - world;
        float perSquare = 1.0 / max(dot(way, way), 0.25);
        vec3 towards = way * sqrt(perSquare);
        float cone = clamp((dot(towards, lightAxes[i].xyz) - lightAxes[i].w) * lightPlaces[i].w, 0.0, 1.0);
        sum += lightColors[i].rgb * (max(dot(normal, towards), 0.0) * perSquare * cone * cone);
    }
    return sum;
}
#endif
