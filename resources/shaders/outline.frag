// A rim outside of who is highlighted, and a line between two of them. Nothing is drawn over
// anybody's clothes.
uniform sampler2D picture; // alpha: highlightOf() in crowd.vert
uniform float reach;       // physical pixels
uniform vec3 selectionColor; // sRGB, as the picture is here
uniform vec3 hoverColor;
out vec4 fragment;

const float kHovered = 20.0 / 255.0; // below
const float kOther = 10.0 / 255.0;   // two who differ by more are two

// 1 on somebody highlighted, 0 beside; between where the picture was smoothed.
float inside(float highlight)
{
    return clamp((0.8 - highlight) * 5.0, 0.0, 1.0);
}

void main()
{
    vec2 pixel = 1.0 / vec2(textureSize(picture, 0));
    vec2 at = gl_FragCoord.xy * pixel;
    vec2 far = pixel * reach;
    vec2 near = far * 0.7;
    float here = texture(picture, at).a;
    float right = texture(picture, at + vec2(far.x, 0.0)).a;
    float up = texture(picture, at + vec2(0.0, far.y)).a;
    float least = min(min(right, up), min(texture(picture, at - vec2(far.x, 0.0)).a,
                                          texture(picture, at - vec2(0.0, far.y)).a));
    least = min(least, min(min(texture(picture, at + near).a, texture(picture, at - near).a),
                           min(texture(picture, at + vec2(near.x, -near.y)).a,
                               texture(picture, at + vec2(-near.x, near.y)).a)));
    float own = inside(here);
    float rim = inside(least) * (1.0 - own);
    bool isApart = (abs(right - here) > kOther && right < 0.6) || (abs(up - here) > kOther && up < 0.6);
    float line = isApart && own == 1.0 ? 0.75 : 0.0;
    fragment = vec4(min(least, here) < kHovered ? hoverColor : selectionColor, max(rim, line));
}
