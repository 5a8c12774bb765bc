#include "app/render/shaders.h"

namespace tractus::render::shaders {

std::string_view const kBackdropFragment = R"(
in vec2 place;
uniform vec3 top;
uniform vec3 bottom;
uniform float aspect;
out vec4 pixel;
void main()
{
    vec2 off = (place - vec2(0.5, 0.52)) * vec2(aspect, 1.0);
    vec3 color = mix(bottom, top, smoothstep(0.15, 1.0, place.y));
    color *= 1.02 - 0.14 * dot(off, off);
    // Dithers by one colour level to prevent bands in the gradient (Jimenez 2014, interleaved gradient noise).
    float grain = fract(52.9829189 * fract(dot(floor(gl_FragCoord.xy), vec2(0.06711056, 0.00583715)))) - 0.5;
    pixel = vec4(color + grain / 255.0, 1.0);
}
)";

std::string_view const kGroundVertex = R"(
uniform vec2 corner;  // Corner of the drawn rectangle at z = 0.
uniform vec2 size;
uniform mat4 T_clip_world;
uniform mat4 T_world_plant;
out vec3 world;
out vec2 place; // Position in the rectangle, 0 to 1.
void main()
{
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    world = (T_world_plant * vec4(corner + size * place, 0.0, 1.0)).xyz;
    gl_Position = T_clip_world * vec4(world, 1.0);
}
)";

std::string_view const kGroundFragment = R"(
in vec3 world;
in vec2 place;
uniform sampler2D sun_ground; // x: share of the sun that is hidden, y: that share times the occluder's distance in mm.
uniform vec3 ground_color;    // Linear light.
uniform float grain_mm;
out vec4 pixel;

// Angular width of the sun as a tangent; larger than the real one, like a sun behind thin haze.
const float kSunWidth = 0.085;

float shadow_at(vec2 uv)
{
    // A coarser mipmap level contributes a little, so that the blur extends beyond the finer one.
    vec2 wide = textureLod(sun_ground, uv, 5.0).xy + 0.02 * textureLod(sun_ground, uv, 7.0).xy;
    if (wide.x <= 0.0)
        return 0.0;
    float blur_texels = wide.y / wide.x * kSunWidth / (2.0 * sun_texel_mm);
    float level = clamp(log2(max(blur_texels, 1.0)) - 0.6, 0.0, 6.0);
    float reach = exp2(level) * 1.5 / sun_map_side; // Distance of the samples, in the units of uv.
    float sum = textureLod(sun_ground, uv, level).x * 0.2;
    sum += textureLod(sun_ground, uv + vec2(reach, reach * 0.4), level).x * 0.2;
    sum += textureLod(sun_ground, uv + vec2(-reach * 0.4, reach), level).x * 0.2;
    sum += textureLod(sun_ground, uv + vec2(-reach, -reach * 0.4), level).x * 0.2;
    sum += textureLod(sun_ground, uv + vec2(reach * 0.4, -reach), level).x * 0.2;
    return sum;
}

void main()
{
    vec2 uv = (T_sun_world * vec4(world, 1.0)).xy * 0.5 + 0.5;
    float shadow = shadow_at(uv);
    float grain = noise(vec3(world.xy / grain_mm, 0.5)) * 0.6 + noise(vec3(world.xy / grain_mm * 3.7, 9.5)) * 0.4;
    vec3 color = ground_color * (0.94 + 0.12 * grain);
    vec3 light = kSunColor * max(sun_direction.z, 0.0) * (1.0 - shadow) * sun_strength + ambient(vec3(0.0, 0.0, 1.0)) * 1.05;
    float radius = length(place * 2.0 - 1.0);
    pixel = vec4(display(color * light), 1.0 - smoothstep(0.22, 0.95, radius));
}
)";

std::string_view const kGroundShadeFragment = R"(
in vec3 world;
in vec2 place;
uniform sampler2D sky_seen;
out vec4 pixel;
void main()
{
    float seen = texture(sky_seen, place).x;
    vec2 edge = smoothstep(vec2(0.0), vec2(0.25), place) * smoothstep(vec2(0.0), vec2(0.25), 1.0 - place);
    float shade = mix(1.0, mix(0.45, 1.0, seen), edge.x * edge.y);
    pixel = vec4(vec3(shade), 1.0);
}
)";

std::string_view const kShadowVertex = R"(
uniform mat4 T_clip_plant;
out vec2 coordinate;
void main()
{
    coordinate = texture_coordinate;
    gl_Position = T_clip_plant * vec4(plant_position(), 1.0);
}
)";

std::string_view const kShadowFragment = R"(
in vec2 coordinate;
uniform float masked; // 1: parts where the picture's alpha is below 0.5 are cut out.
uniform sampler2D picture;
void main()
{
    if (masked > 0.0 && texture(picture, coordinate).a < 0.5)
        discard;
}
)";

std::string_view const kGroundShadowFragment = R"(
in vec2 place;
uniform sampler2D sun_depth;
uniform mat4 T_world_clip;
uniform vec3 sun_direction;
out vec4 pixel;
void main()
{
    ivec2 corner = ivec2(gl_FragCoord.xy) * 2;
    vec2 sum = vec2(0.0);
    for (int i = 0; i < 4; ++i) {
        float depth = texelFetch(sun_depth, corner + ivec2(i & 1, i >> 1), 0).x;
        float height = (T_world_clip * vec4(place * 2.0 - 1.0, depth * 2.0 - 1.0, 1.0)).z;
        float hides = depth < 1.0 && height > 0.0 ? 0.25 : 0.0;
        sum += vec2(1.0, min(height / max(sun_direction.z, 0.05), 60000.0)) * hides;
    }
    pixel = vec4(sum, 0.0, 1.0);
}
)";

} // namespace tractus::render::shaders
