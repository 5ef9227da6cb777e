// Prepended to shaders that light surfaces. All colours are linear.
uniform vec3 sunDirection; // towards the sun, unit
uniform vec3 sunColor;
uniform vec3 skyColor;    // ambient from above
uniform vec3 bounceColor; // ambient from below

vec3 lightAt(vec3 normal)
{
#ifdef LIT
    return sunColor * max(dot(normal, sunDirection), 0.0) +
           mix(bounceColor, skyColor, normal.y * 0.5 + 0.5);
#else
    return vec3(1.0);
#endif
}
