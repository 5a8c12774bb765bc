#include "app/render/shaders.h"

namespace tractus::render::shaders {

std::string_view const kPictureVertex = R"(
uniform mat4 T_clip_world;
uniform vec3 corner; // Upper left corner of the picture; its edges are `right` and `down`.
uniform vec3 right;
uniform vec3 down;

out vec2 place; // Position in the picture, 0 to 1, rows from top to bottom.

void main()
{
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = T_clip_world * vec4(corner + place.x * right + place.y * down, 1.0);
}
)";

// Fragment shader that shows the picture's colours as they are, without lighting or tone mapping.
std::string_view const kPictureFragment = R"(
uniform sampler2D picture;
uniform float strength;

in vec2 place;
out vec4 color;

void main()
{
    color = texture(picture, place);
    color.a *= strength;
}
)";

} // namespace tractus::render::shaders
