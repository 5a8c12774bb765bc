#include "app/render/shaders.h"

namespace tractus::render::shaders {

std::string_view const kPlacement = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 texture_coordinate;
layout(location = 3) in float vertex_sky;
layout(location = 4) in vec3 instance_translation;
layout(location = 5) in vec4 instance_rotation;
layout(location = 6) in vec3 instance_scale;
layout(location = 7) in float instance_sky;
layout(location = 8) in vec2 individual_values;

vec3 rotated(vec4 q, vec3 v) { return v + 2.0 * cross(q.xyz, cross(q.xyz, v) + q.w * v); }

vec3 plant_position() { return instance_translation + rotated(instance_rotation, instance_scale * position); }

vec3 plant_normal() { return rotated(instance_rotation, normal / instance_scale); }
)";

std::string_view const kSurfaceVertex = R"(
uniform mat4 T_world_plant;
uniform mat4 T_clip_world;

out vec3 world;
out vec3 world_normal;
out vec2 coordinate;
out float sky;
flat out vec2 individual; // Random values of the organ, 0 to 1; 0.5 for surfaces of a single part.

void main()
{
    vec4 place = T_world_plant * vec4(plant_position(), 1.0);
    world = place.xyz;
    world_normal = mat3(T_world_plant) * plant_normal();
    coordinate = texture_coordinate;
    sky = vertex_sky * instance_sky;
    individual = individual_values;
    gl_Position = T_clip_world * place;
}
)";

// Fragment shader of surfaces. It is compiled to three programs: with BARK defined, with THIN
// defined (for leaves and petals), and with neither.
std::string_view const kSurfaceFragment = R"(
in vec3 world;
in vec3 world_normal;
in vec2 coordinate;
in float sky;
flat in vec2 individual;

uniform vec3 eye;
uniform vec3 base_color; // Linear light; multiplied by the picture, if there is one.
uniform float pictured;  // 1 if there is a picture, otherwise 0.
uniform float masked;    // 1: parts where the picture's alpha is below 0.5 are cut out.
uniform sampler2D picture;
uniform float bumped; // Strength of the normal map, or 0 if there is none; the maps below have strengths, too.
uniform sampler2D normals;
uniform float occluded;
uniform sampler2D occlusions; // Ambient occlusion in the red channel.
uniform float roughened;
uniform sampler2D roughnesses; // Roughness in the green channel, metalness in the blue one.
uniform float passing;
uniform sampler2D passings; // Translucency in the alpha channel.
uniform float roughness;
uniform float metalness;
uniform float translucency;
uniform float veins;
uniform float drawn_veins; // 1: the shader draws veins; 0: it does not.
uniform float is_lit; // 0: the surface's own colour is shown, without lighting.

out vec4 pixel;

float coverage = 1.0; // Share of the pixel that the picture's mask covers.

// Samples the surface's colour and sets its coverage. The picture's mipmap levels keep the coverage of
// its mask; between its two sides the edge is one pixel wide.
vec3 surface_color()
{
    if (pictured == 0.0)
        return base_color;
    vec4 seen = texture(picture, coordinate);
    if (masked > 0.0)
        coverage = clamp((seen.a - 0.5) / max(fwidth(seen.a), 1e-3) + 0.5, 0.0, 1.0);
    return base_color * seen.rgb;
}

vec4 own_color(vec3 color) { return vec4(pow(clamp(color, 0.0, 1.0), vec3(1.0 / 2.2)), coverage); }

float surface_roughness() { return roughened > 0.0 ? roughness * texture(roughnesses, coordinate).g : roughness; }

float surface_metal() { return roughened > 0.0 ? metalness * texture(roughnesses, coordinate).b : metalness; }

float surface_translucency() { return passing > 0.0 ? translucency * texture(passings, coordinate).a : translucency; }

// Share of the sky that the surface's own relief does not occlude.
float surface_openness() { return occluded > 0.0 ? mix(1.0, texture(occlusions, coordinate).r, occluded) : 1.0; }

// Computes unit tangents along which u and v increase, perpendicular to the normal, from screen-space
// derivatives.
void find_tangents(vec3 n, out vec3 along_u, out vec3 along_v)
{
    vec2 step_x = dFdx(coordinate);
    vec2 step_y = dFdy(coordinate);
    float turn = sign(step_x.x * step_y.y - step_x.y * step_y.x);
    vec3 u = (dFdx(world) * step_y.y - dFdy(world) * step_x.y) * turn;
    vec3 v = (dFdy(world) * step_x.x - dFdx(world) * step_y.x) * turn;
    along_u = normalize(u - n * dot(u, n) + vec3(1e-9));
    along_v = normalize(v - n * dot(v, n) + vec3(1e-9));
}

// The normal modified by the normal map, whose green channel points against v.
vec3 bumped_normal(vec3 n)
{
    if (bumped == 0.0)
        return n;
    vec3 along_u;
    vec3 along_v;
    find_tangents(n, along_u, along_v);
    vec3 leaning = texture(normals, coordinate).xyz * 2.0 - 1.0;
    return normalize(n * max(leaning.z, 0.05) + (along_u * leaning.x - along_v * leaning.y) * bumped);
}

// Light at one place, not yet multiplied by the surface's colour.
struct Light {
    vec3 front;    // Light on the visible side.
    vec3 through;  // Light on the other side, which may shine through.
    vec3 gloss;    // Specular reflection, independent of the colour.
};

float mirrored(vec3 n, vec3 view, float rough)
{
    // Normalised Blinn-Phong lobe with Schlick's Fresnel term for the wax of plants (0.04).
    vec3 h = normalize(sun_direction + view);
    float power = 2.0 / max(rough * rough * rough * rough, 0.002);
    float fresnel = 0.04 + 0.96 * pow(1.0 - max(dot(h, view), 0.0), 5.0);
    return fresnel * (power + 8.0) / 25.0 * pow(max(dot(n, h), 0.0), power) * max(dot(n, sun_direction), 0.0);
}

Light light_at(vec3 n, vec3 view)
{
    float sun = sunlit(world, n);
    float rough = surface_roughness();
    float open = (sky * sky * 0.25 + sky * 0.75) * surface_openness();
    float facing = dot(n, sun_direction);
    vec3 filtered = mix(vec3(0.80, 0.92, 0.52), vec3(1.0), sky); // Light filtered by other leaves is greener.
    Light light;
    light.front = kSunColor * max(facing, 0.0) * sun + ambient(n) * open * filtered;
    light.through = kSunColor * max(-facing, 0.0) * sun + ambient(-n) * open * filtered;
    float rim = pow(1.0 - max(dot(n, view), 0.0), 4.0) * (1.0 - rough) * 0.35;
    light.gloss = kSunColor * mirrored(n, view, rough) * sun + kSkyColor * rim * open;
    return light;
}

#ifdef BARK
// Height of the bark's furrows: ridged noise on a cylinder, which has no seam.
float bark_height(vec2 uv)
{
    float angle = uv.x * 6.2831853;
    vec3 p = vec3(cos(angle), sin(angle), uv.y * 6.2831853 * 0.22);
    float wander = noise(p * vec3(2.0, 2.0, 5.0) + 7.0);
    float coarse = 1.0 - abs(2.0 * noise(p * 3.4 + wander * 0.8) - 1.0);
    float fine = 1.0 - abs(2.0 * noise(p * vec3(8.0, 8.0, 11.0) + 31.0 + wander) - 1.0);
    return 0.68 * coarse + 0.32 * fine;
}

void main()
{
    vec3 n = normalize(world_normal);
    vec3 view = normalize(eye - world);
    float footprint = max(length(dFdx(coordinate)), length(dFdy(coordinate)));
    float detail = 1.0 - smoothstep(0.008, 0.032, footprint);
    float height = bark_height(coordinate);

    // Bump mapping: tilts the normal against the slope of the height. The slope is computed on the surface,
    // since screen-space derivatives are constant in blocks of 2 x 2 pixels, which would be visible.
    if (bumped == 0.0) {
        vec3 around;
        vec3 along;
        find_tangents(n, around, along);
        const float reach = 0.006;
        float slope_around = bark_height(coordinate + vec2(reach, 0.0)) - height;
        float slope_along = bark_height(coordinate + vec2(0.0, reach)) - height;
        n = normalize(n - (around * slope_around + along * slope_along) * (detail * 0.055 / reach));
    }
    n = bumped_normal(n);

    vec3 color = surface_color() * mix(0.95, mix(0.50, 1.40, smoothstep(0.30, 0.95, height)), detail * (1.0 - pictured));
    color = mix(color, vec3(dot(color, vec3(0.33))) * vec3(1.05, 1.0, 0.92), 0.25 * height * detail * (1.0 - pictured));
    if (is_lit == 0.0) {
        pixel = own_color(color);
        return;
    }
    Light light = light_at(n, view);
    pixel = vec4(display(color * light.front + light.gloss * 0.6), coverage);
}
#endif

#ifdef THIN
// Strength of the midrib and side veins, 0 to 1, at a place in the blade's unit square.
float vein_at(vec2 uv)
{
    float across = abs(uv.x - 0.5) * 2.0;
    float rib = exp(-across * across * 260.0);
    float side = abs(fract((uv.y - across * 0.30) * 8.0) - 0.5) * 2.0;
    float fading = 1.0 - smoothstep(0.03, 0.12, max(length(dFdx(uv)), length(dFdy(uv))));
    return max(rib, smoothstep(0.80, 1.0, side) * 0.55 * (1.0 - across)) * fading;
}

void main()
{
    vec3 n = normalize(world_normal);
    vec3 view = normalize(eye - world);
    bool underside = dot(n, view) < 0.0;
    n = bumped_normal(n);
    if (underside)
        n = -n;
    float change = individual.x - 0.5;
    vec3 color = surface_color() * (1.0 + (individual.y - 0.5) * 0.34);
    color *= mix(vec3(1.0), vec3(1.0 + change * 0.55, 1.0 + change * 0.12, 1.0 - change * 0.45), veins * 0.85 + 0.15);
    float vein = veins * drawn_veins * vein_at(coordinate);
    color = mix(color, color * 1.5 + vec3(0.03, 0.035, 0.012), vein * 0.55);
    if (underside)
        color = mix(color, vec3(dot(color, vec3(0.30, 0.55, 0.15))) * vec3(1.06, 1.1, 0.92), 0.25 * veins) * (1.0 + 0.12 * veins);
    if (is_lit == 0.0) {
        pixel = own_color(color);
        return;
    }
    vec3 shining = color * mix(vec3(1.25), vec3(1.75, 1.45, 0.42), veins) * (1.0 - vein * 0.45);
    Light light = light_at(n, view);
    float passes = surface_translucency();
    vec3 sum = color * light.front * (1.0 - 0.45 * passes) + shining * light.through * passes
        + light.gloss * (underside ? 0.3 : 1.0);
    pixel = vec4(display(sum), coverage);
}
#endif

#ifdef PLAIN
void main()
{
    vec3 n = bumped_normal(normalize(world_normal));
    vec3 view = normalize(eye - world);
    vec3 color = surface_color() * (0.92 + 0.16 * individual.y);
    if (is_lit == 0.0) {
        pixel = own_color(color);
        return;
    }
    Light light = light_at(n, view);
    vec3 sum = color * light.front + light.gloss;
    float metal = surface_metal();
    if (metal > 0.0) { // Metals reflect in their own colour and scatter no light.
        vec3 mirrored_sky = ambient(reflect(-view, n)) * sky * surface_openness();
        sum = mix(sum, color * (mirrored_sky + light.gloss / 0.04), metal);
    }
    pixel = vec4(display(sum), coverage);
}
#endif
)";

} // namespace tractus::render::shaders
