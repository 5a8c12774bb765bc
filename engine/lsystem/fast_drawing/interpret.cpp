#include "engine/lsystem/fast_drawing/interpret.h"

#include "engine/base/parallel.h"
#include "engine/lsystem/fast_drawing/piece_turtle.h"
#include "engine/lsystem/fast_drawing/segment_plan.h"
#include "engine/lsystem/rewriting/homomorphism.h"
#include "engine/lsystem/turtle/plant_assembly.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <atomic>
#include <fmt/core.h>
#include <optional>
#include <set>
#include <span>
#include <vector>

namespace tractus::lsystem {

namespace {

// Returns true if pieces of a string may be drawn in any order: no homomorphism rule has side
// effects or keeps local variables.
bool is_divisible(Model const& model)
{
    auto const& rules = model.homomorphism.rules;
    return std::none_of(rules.begin(), rules.end(), [](Rule const& rule) {
        return rule.keeps_locals || has_effects(rule.condition)
            || has_effects(rule.successor_program) || has_effects(rule.probability);
    });
}

Piece whole(DrawingJob const& job)
{
    Piece piece;
    piece.end = job.string.size();
    piece.start = Turtle(job.model, job.options).start();
    return piece;
}

// Draws several pieces in parallel, each by draw(turtle, number). Returns false if a piece is
// incomplete or a limit is exceeded.
template<typename Draw>
bool draw_generation(DrawingJob& job, std::span<Piece const> pieces, BranchIndex const* index,
                     Draw const& draw)
{
    std::atomic<bool> is_good = true;
    parallel_for(pieces.size(), 1, [&](std::size_t begin, std::size_t end) {
        PieceTurtle turtle(job, index);
        for (auto i = begin; i < end; ++i) {
            draw(turtle, i);
            if (!pieces[i].is_complete || turtle.machine().has_stopped() || job.is_over_limit())
                is_good = false;
        }
    });
    return is_good;
}

// The drawn pieces of a string. If they were planned, their axes and segments are already in
// `plant`.
struct DrawnString {
    std::vector<Piece> pieces;
    Plant plant {};
};

// Draws the string in pieces. Each piece leaves its long branches to further pieces.
std::optional<DrawnString> draw_in_pieces(DrawingJob& job, BranchIndex const& index)
{
    std::vector<Piece> pieces { whole(job) };
    for (std::size_t first = 0; first < pieces.size();) {
        auto const end = pieces.size();
        if (!draw_generation(
                job, std::span(pieces).subspan(first), &index,
                [&](PieceTurtle& turtle, std::size_t i) { turtle.draw(pieces[first + i]); }))
            return std::nullopt;
        for (; first < end; ++first) {
            auto branches = std::move(pieces[first].branches);
            for (std::size_t i = 0; i < branches.size(); ++i) {
                pieces[first].drawn.drawing.gaps[i].piece = pieces.size();
                branches[i].drawn.parent = first;
                pieces.push_back(std::move(branches[i]));
            }
        }
    }
    return DrawnString { std::move(pieces) };
}

// Draws each piece of a plan directly to its place in the plant.
std::optional<DrawnString> draw_as_planned(DrawingJob& job, std::vector<PlannedPiece> const& plan)
{
    job.parts = plan[0].segment_count;
    job.bytes = job.parts * (sizeof(Vec3) + sizeof(float) + sizeof(std::uint8_t));
    if (job.is_over_limit())
        return std::nullopt;
    DrawnString result { std::vector<Piece>(plan.size()) };
    auto& pieces = result.pieces;
    auto& plant = result.plant;
    make_room(plant, plan[0].axis_count, plan[0].segment_count);
    pieces[0] = whole(job);
    pieces[0].target = { &plant, 0, 0, plan[0].axis_lengths };
    for (std::size_t first = 0, end = 1; first < end;) {
        std::span const generation(pieces.data() + first, end - first);
        if (!draw_generation(job, generation, nullptr, [&](PieceTurtle& turtle, std::size_t i) {
                turtle.draw(plan, first + i, pieces);
            }))
            return std::nullopt;
        for (auto const count = end; first < count; ++first)
            end += plan[first].gaps.size();
    }
    return result;
}

// Draws the string in pieces, in parallel. Returns no value if it must be drawn sequentially: it is
// too short, the order of its modules matters (as with sub-L-systems), its brackets do not match,
// or errors must be reported in the order of the string.
std::optional<DrawnString> draw_divided(DrawingJob& job, ParameterRange const& parameters)
{
    if (job.string.size() < 4 * job.options.long_branch || !is_divisible(job.model)
        || !job.model.subsystems.empty() || uses_patches(job.model))
        return std::nullopt;
    BranchIndex const index(job.model, job.string, job.options.long_branch);
    if (auto const plan = plan_segments(job.model, job.string, job.options, index, parameters))
        return draw_as_planned(job, *plan);
    return draw_in_pieces(job, index);
}

Result<DrawnString> draw_at_once(DrawingJob& job)
{
    job.drawn = job.parts = job.bytes = 0;
    std::vector<Piece> pieces { whole(job) };
    PieceTurtle turtle(job, nullptr);
    turtle.draw(pieces.front());
    TRY(turtle.machine().check());
    if (job.drawn > job.options.max_modules)
        return fail(
            Fault::User,
            fmt::format("{}: the homomorphism makes more than {} modules; derive fewer steps "
                        "or raise the limit",
                        job.model.name, job.options.max_modules));
    if (job.bytes > job.options.max_memory_bytes)
        return fail(Fault::User,
                    fmt::format("{}: the plant needs more than {} MB; derive fewer steps or raise "
                                "the limit of memory",
                                job.model.name, job.options.max_memory_bytes >> 20));
    if (job.parts > job.options.max_parts)
        return fail(Fault::User,
                    fmt::format("{}: the plant has more than {} segments, organs and polygons; "
                                "derive fewer steps",
                                job.model.name, job.options.max_parts));
    return DrawnString { std::move(pieces) };
}

// Collects the warnings of all pieces, each once, in the order of the string.
std::vector<std::string> gather_warnings(Model const& model, std::vector<Piece> const& pieces)
{
    std::vector<TurtleDrawing::Warning> all;
    for (auto const& piece : pieces)
        all.insert(all.end(), piece.drawn.drawing.warnings.begin(),
                   piece.drawn.drawing.warnings.end());
    std::stable_sort(all.begin(), all.end(),
                     [](auto const& a, auto const& b) { return a.module < b.module; });
    std::vector<std::string> result;
    if (model.view.tropisms.size() > kMaxTropisms)
        result.push_back(
            fmt::format("{}: only the first {} tropisms count", model.name, kMaxTropisms));
    std::set<std::string> seen;
    for (auto& warning : all)
        if (seen.insert(warning.text).second)
            result.push_back(std::move(warning.text));
    return result;
}

Result<TurtlePlant> draw_string(DrawingJob& job)
{
    auto const& model = job.model;
    auto const& options = job.options;
    if (std::any_of(model.homomorphism.rules.begin(), model.homomorphism.rules.end(),
                    [](Rule const& rule) { return !rule.left.empty() || !rule.right.empty(); }))
        find_branches(model, job.string, job.branches);
    auto const parameters = parameter_range(job.string);
    job.is_finite = parameters.are_finite();
    auto divided = draw_divided(job, parameters);
    auto [pieces, plant] = divided ? std::move(*divided) : TRY(draw_at_once(job));
    TurtlePlant result;
    result.warnings = gather_warnings(model, pieces);
    std::vector<DrawnPiece> drawn;
    drawn.reserve(pieces.size());
    for (auto& piece : pieces)
        drawn.push_back(std::move(piece.drawn));
    result.plant = assemble_plant(model.view, options.unit_mm, drawn, std::move(plant));
    if (model.view.pipe_model)
        apply_pipe_model(result.plant, model.view.pipe_exponent,
                         model.view.pipe_tip_radius * options.unit_mm);
    return result;
}

} // namespace

Result<TurtlePlant> interpret_with_warnings(Model const& model, ModuleString const& string,
                                            TurtleOptions const& options)
{
    DrawingJob job { model, string, options };
    if (model.subsystems.empty())
        return draw_string(job);
    // Each sub-L-system has its own homomorphism rules, so these are applied to the whole string
    // first.
    HomomorphismOptions how;
    how.limit.modules = options.max_modules;
    how.limit.bytes = options.max_memory_bytes;
    how.time = options.time;
    how.print = options.print;
    how.cuts = HomomorphismOptions::Cuts::KeepThoseOfTheString;
    auto const expanded = TRY(apply_homomorphism(model, string, how));
    DrawingJob expanded_job { model, expanded, options, true };
    return draw_string(expanded_job);
}

Result<Plant> interpret(Model const& model, ModuleString const& string,
                        TurtleOptions const& options)
{
    return TRY(interpret_with_warnings(model, string, options)).plant;
}

} // namespace tractus::lsystem
