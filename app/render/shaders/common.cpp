#include "app/render/shaders.h"

namespace tractus::render::shaders {

std::string_view const kColor = R"(
vec3 linear(vec3 srgb) { return pow(srgb, vec3(2.2)); }

// Tone mapping with a white point (Reinhard et al. 2002, "Photographic tone reproduction for digital
// images", equation 4), followed by the screen's gamma.
vec3 display(vec3 light)
{
    const float white = 2.6;
    vec3 toned = light * (1.0 + light / (white * white)) / (1.0 + light);
    return pow(clamp(toned * 1.12, 0.0, 1.0), vec3(1.0 / 2.2));
}
)";

std::string_view const kNoise = R"(
float random_at(uvec3 p)
{
    uint h = p.x * 0x8da6b343u ^ p.y * 0xd8163841u ^ p.z * 0xcb1ab31fu;
    h = (h ^ (h >> 15)) * 0x2c1b3c6du;
    h ^= h >> 12;
    return float(h & 0xffffu) / 65535.0;
}

// Value noise: random values at integer coordinates, smoothly interpolated; 0 to 1.
float noise(vec3 place)
{
    vec3 cell = floor(place);
    vec3 f = place - cell;
    f = f * f * (3.0 - 2.0 * f);
    uvec3 c = uvec3(ivec3(cell));
    vec4 low = vec4(random_at(c), random_at(c + uvec3(1, 0, 0)), random_at(c + uvec3(0, 1, 0)), random_at(c + uvec3(1, 1, 0)));
    c.z += 1u;
    vec4 high = vec4(random_at(c), random_at(c + uvec3(1, 0, 0)), random_at(c + uvec3(0, 1, 0)), random_at(c + uvec3(1, 1, 0)));
    vec4 plane = mix(low, high, f.z);
    vec2 row = mix(plane.xz, plane.yw, f.x);
    return mix(row.x, row.y, f.y);
}
)";

std::string_view const kFullScreenVertex = R"(
out vec2 place; // Position on the screen, 0 to 1.
void main()
{
    place = vec2(gl_VertexID == 1 ? 2.0 : 0.0, gl_VertexID == 2 ? 2.0 : 0.0);
    gl_Position = vec4(place * 2.0 - 1.0, 0.0, 1.0);
}
)";

std::string_view const kSunlight = R"(
uniform sampler2DShadow sun_depth;
uniform mat4 T_sun_world;
uniform vec3 sun_direction;
uniform float sun_texel_mm;
uniform float sun_depth_mm;
uniform float sun_map_side;
uniform float sun_strength;

const vec3 kSunColor = vec3(1.0, 0.93, 0.80) * 2.9;
const vec3 kSkyColor = vec3(0.68, 0.81, 1.0) * 0.92;
const vec3 kBounceColor = vec3(0.52, 0.47, 0.38) * 0.95;

// Ambient light: from the sky above, and reflected by the ground from below.
vec3 ambient(vec3 normal) { return mix(kBounceColor, kSkyColor, normal.z * 0.5 + 0.5); }

// Share of the sun that reaches a place on a plant: the mean of five look-ups in the sun's depth map, each
// of which interpolates four depth comparisons.
float sunlit(vec3 world, vec3 normal)
{
    vec3 off = world + normal * (sign(dot(normal, sun_direction)) * sun_texel_mm * 1.5);
    vec3 at = (T_sun_world * vec4(off, 1.0)).xyz * 0.5 + 0.5;
    at.z -= 2.0 * sun_texel_mm / sun_depth_mm;
    float r = 1.6 / sun_map_side;
    float sum = texture(sun_depth, at);
    sum += texture(sun_depth, at + vec3(0.95, 0.31, 0.0) * r);
    sum += texture(sun_depth, at + vec3(-0.31, 0.95, 0.0) * r);
    sum += texture(sun_depth, at + vec3(-0.95, -0.31, 0.0) * r);
    sum += texture(sun_depth, at + vec3(0.31, -0.95, 0.0) * r);
    return sum * 0.2 * sun_strength;
}
)";

} // namespace tractus::render::shaders
