#include "app/render/shaders.h"

namespace tractus::render::shaders {

// Vertex shader of curves. It expands each segment to a screen rectangle around its two round ends;
// the fragment shader then computes each pixel's distance from the segment's centre line.
std::string_view const kCurveVertex = R"(
layout(location = 0) in vec3 begin_position;
layout(location = 1) in vec3 begin_color;
layout(location = 2) in float begin_width;
layout(location = 3) in vec3 end_position;
layout(location = 4) in vec3 end_color;
layout(location = 5) in float end_width;
layout(location = 6) in vec2 traits; // x: 1 if widths are in millimetres; y: sum of 1 if round, 2 if an arrow's head, 4 if it fades.

uniform mat4 T_clip_world;
uniform vec2 viewport_px;
uniform float pixels_per_mm; // Scale where clip w is 1.
uniform vec2 depth_terms;    // Elements (2, 2) and (2, 3) of the projection matrix.
uniform vec3 fade_color;
uniform vec3 fade_terms; // x: greatest share of fade_color, y: height below which curves fade, z: 1 / range.

noperspective out vec2 at_px;
flat out vec2 begin_px;
flat out vec2 end_px;
flat out vec2 radii_px;
flat out vec2 heights_mm;
flat out vec3 color_a;
flat out vec3 color_b;
flat out float look; // The value of traits.y without the 4 for fading.
flat out vec2 cap_depths; // Depth offset of the two round ends.

float radius_of(float width, float w) { return 0.5 * width * (traits.x > 0.5 ? pixels_per_mm / w : 1.0); }

// Depth offset of a round end: one radius, so that an end between two segments fills the gap without
// covering its neighbour.
float cap_depth(float radius_px, float w)
{
    float radius_mm = radius_px * w / pixels_per_mm;
    bool perspective = depth_terms.y != 0.0 && w != 1.0;
    return 0.5 * (perspective ? depth_terms.y / (w + radius_mm) - depth_terms.y / w : -depth_terms.x * radius_mm);
}

vec3 faded(vec3 color, float height)
{
    float depth = traits.y > 3.5 ? (fade_terms.y - height) * fade_terms.z : 0.0;
    return mix(color, fade_color, fade_terms.x * clamp(depth, 0.0, 1.0));
}

void main()
{
    vec4 a = T_clip_world * vec4(begin_position, 1.0);
    vec4 b = T_clip_world * vec4(end_position, 1.0);
    // Clips the part behind the eye.
    const float nearest = 1e-3;
    if (a.w < nearest && b.w < nearest) {
        gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
        return;
    }
    if (a.w < nearest)
        a = mix(a, b, (nearest - a.w) / (b.w - a.w));
    if (b.w < nearest)
        b = mix(b, a, (nearest - b.w) / (a.w - b.w));

    begin_px = (a.xy / a.w * 0.5 + 0.5) * viewport_px;
    end_px = (b.xy / b.w * 0.5 + 0.5) * viewport_px;
    radii_px = vec2(radius_of(begin_width, a.w), radius_of(end_width, b.w));
    heights_mm = vec2(begin_position.z, end_position.z);
    color_a = faded(begin_color, begin_position.z);
    color_b = faded(end_color, end_position.z);
    look = mod(traits.y, 4.0);
    cap_depths = vec2(cap_depth(radii_px.x, a.w), cap_depth(radii_px.y, b.w));

    vec2 run = end_px - begin_px;
    if (look > 1.5 && traits.x < 0.5) { // The length of an arrow's head follows from its width; see GpuCurves.
        run = normalize(run) * (begin_width * 7.0 / 4.5);
        end_px = begin_px + run;
        radii_px.y = 0.0;
    }
    vec2 along = dot(run, run) > 1e-8 ? normalize(run) : vec2(1.0, 0.0);
    float reach = max(max(radii_px.x, radii_px.y), 0.7) + 1.0;
    bool at_end = (gl_VertexID & 1) != 0;
    float side = (gl_VertexID & 2) != 0 ? 1.0 : -1.0;
    at_px = (at_end ? end_px + along * reach : begin_px - along * reach) + vec2(-along.y, along.x) * side * reach;
    vec4 end = at_end ? b : a;
    gl_Position = vec4((at_px / viewport_px * 2.0 - 1.0) * end.w, end.z, end.w);
}
)";

std::string_view const kCurveFragment = R"(
noperspective in vec2 at_px;
flat in vec2 begin_px;
flat in vec2 end_px;
flat in vec2 radii_px;
flat in vec2 heights_mm;
flat in vec3 color_a;
flat in vec3 color_b;
flat in float look;
flat in vec2 cap_depths;
uniform float hidden_above_mm;
out vec4 pixel;

void main()
{
    vec2 run = end_px - begin_px;
    float run_px = max(length(run), 1e-4);
    vec2 along = run / run_px;
    float place_px = dot(at_px - begin_px, along);
    float t = clamp(place_px / run_px, 0.0, 1.0);
    if (mix(heights_mm.x, heights_mm.y, t) > hidden_above_mm)
        discard;
    float radius = mix(radii_px.x, radii_px.y, t);
    float drawn = max(radius, 0.7); // Least radius; a thinner line is drawn paler instead.
    vec2 off = at_px - begin_px - run * t;
    float cover = clamp(drawn - length(off) + 0.5, 0.0, 1.0) * min(radius / 0.7, 1.0);
    if (look > 1.5)
        cover = min(clamp(radius - length(off) + 0.5, 0.0, 1.0), clamp(place_px + 0.5, 0.0, 1.0));
    if (cover < 0.1)
        discard;
    // Shades the line as a tube by the offset across it only, so that the round ends between segments are
    // invisible.
    float across = clamp(dot(off, vec2(-along.y, along.x)) / max(drawn, 1e-3), -1.0, 1.0);
    vec3 normal = vec3(vec2(-along.y, along.x) * across, sqrt(1.0 - across * across));
    float facing = max(dot(normal, normalize(vec3(-0.5, 0.65, 0.75))), 0.0);
    float roundness = mod(look, 2.0) * smoothstep(1.0, 2.5, max(radii_px.x, radii_px.y));
    vec3 color = mix(color_a, color_b, t);
    color *= mix(1.0, 0.62 + 0.46 * facing, roundness);
    color += roundness * 0.20 * pow(facing, 24.0);
    gl_FragDepth = gl_FragCoord.z + (place_px < 0.0 ? cap_depths.x : place_px > run_px ? cap_depths.y : 0.0);
    pixel = vec4(color, cover);
}
)";

std::string_view const kCurveShadowFragment = R"(
noperspective in vec2 at_px;
flat in vec2 begin_px;
flat in vec2 end_px;
flat in vec2 radii_px;
flat in vec2 heights_mm;
flat in vec3 color_a;
flat in vec3 color_b;
flat in float look;
uniform float hidden_above_mm;

void main()
{
    vec2 run = end_px - begin_px;
    float t = clamp(dot(at_px - begin_px, run) / max(dot(run, run), 1e-8), 0.0, 1.0);
    if (mix(heights_mm.x, heights_mm.y, t) > hidden_above_mm)
        discard;
    if (length(at_px - begin_px - run * t) > max(mix(radii_px.x, radii_px.y, t), 0.5))
        discard;
}
)";

} // namespace tractus::render::shaders
