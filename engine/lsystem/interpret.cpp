#include "engine/lsystem/interpret.h"

#include "engine/base/arena.h"
#include "engine/base/parallel.h"
#include "engine/lsystem/branch_index.h"
#include "engine/lsystem/expander.h"
#include "engine/lsystem/homomorphism.h"
#include "engine/lsystem/plant_assembly.h"
#include "engine/lsystem/turtle.h"
#include "engine/plant/pipe_model.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <fmt/core.h>
#include <optional>
#include <set>
#include <vector>

namespace tractus {

namespace {

// So many modules may be drawn before the limits are looked at.
constexpr std::size_t kBatch = 1024;

// A part of the string, outside of the branches left out of it, and what is drawn there.
struct Piece {
    std::size_t begin = 0;
    std::size_t end = 0;
    std::size_t parameter = 0; // Where the first module's parameters begin.
    std::int64_t depth = 0;    // Of the first module, counted from the string's beginning.
    Turtle::Start start;
    DrawnPiece drawn;
    std::vector<Piece> branches; // Left out, in the order of the string.
    bool is_complete = true;     // Ends as if it had been drawn by itself.
};

// What all pieces of one string share.
struct Job {
    Model const& model;
    ModuleString const& string;
    TurtleOptions const& options;
    bool is_expanded = false; // The homomorphism has been applied.
    bool is_finite = false;   // All parameters of the string are.
    Branches branches {};     // Where homomorphism rules have contexts.
    Arena memory {};          // What pieces have drawn.
    std::atomic<std::size_t> drawn { 0 };
    std::atomic<std::size_t> parts { 0 };

    bool is_over_limit() const { return drawn > options.max_modules || parts > options.max_parts; }
};

// Draws pieces, one after the other. Each thread needs its own.
class PieceTurtle {
public:
    // `index` is nullptr where no branches are to be left out.
    PieceTurtle(Job& job, BranchIndex const* index)
        : job_(job)
        , model_(job.model)
        , string_(job.string)
        , index_(index)
        , machine_(job.model, job.string)
        , homomorphism_(job.model, job.model.homomorphism, machine_)
        , turtle_(job.model, job.options)
    {
        machine_.set_time_limit(&job.options.time);
        for (std::size_t i = 0; i < model_.alphabet.kinds.size(); ++i) {
            has_rules_[i] = !job.is_expanded && homomorphism_.has_rules(static_cast<KindId>(i));
            opens_[i] = model_.alphabet.kinds[i].symbol == '[' && !has_rules_[i];
            stops_[i] = has_rules_[i] || (index_ && opens_[i]);
            parameter_counts_[i] = model_.alphabet.kinds[i].parameter_count;
        }
    }

    void draw(Piece& piece);

    Machine const& machine() const { return machine_; }

private:
    void draw_plain(std::size_t end);
    std::size_t draw_one();
    bool leave_out(Piece& piece);
    void count();
    void pass(std::size_t count)
    {
        for (; count > 0; --count)
            parameter_ += parameter_counts_[string_.kinds[at_++]];
    }

    Job& job_;
    Model const& model_;
    ModuleString const& string_;
    BranchIndex const* index_;
    Machine machine_;
    Expander homomorphism_;
    Turtle turtle_;
    Drawing drawing_; // Of one piece: the same memory for one after the other.
    std::array<bool, 256> has_rules_ {};
    std::array<bool, 256> opens_ {};
    std::array<bool, 256> stops_ {}; // Kinds that are more than a symbol to draw.
    std::array<std::uint8_t, 256> parameter_counts_ {};
    std::size_t at_ = 0;
    std::size_t parameter_ = 0;
    std::size_t look_from_ = 0; // Branches that begin before it are drawn here.
    std::size_t drawn_ = 0;     // Not counted yet.
    std::size_t counted_parts_ = 0;
};

void PieceTurtle::draw(Piece& piece)
{
    drawing_.clear();
    turtle_.begin(piece.start, drawing_);
    at_ = piece.begin;
    parameter_ = piece.parameter;
    look_from_ = piece.begin;
    counted_parts_ = 0;
    while (at_ < piece.end) {
        if (index_ && at_ >= look_from_)
            look_from_ = index_->next_opening(at_);
        auto const end = at_ < look_from_ ? std::min(piece.end, look_from_) : piece.end;
        if (job_.is_finite)
            draw_plain(at_ + std::min(end - at_, kBatch));
        if (at_ == piece.end)
            break;
        if (index_ && opens_[string_.kinds[at_]] && at_ >= look_from_ && leave_out(piece))
            continue;
        pass(draw_one());
        if (turtle_.take_cut())
            pass(branch_end(model_, string_, at_) - at_);
        if (drawn_ >= kBatch) {
            count();
            if (job_.is_over_limit() || machine_.has_stopped())
                return;
        }
    }
    count();
    piece.drawn.drawing = drawing_.copy(job_.memory);
    piece.is_complete = turtle_.is_complete() && at_ == piece.end;
}

void PieceTurtle::count()
{
    job_.drawn += std::exchange(drawn_, 0);
    job_.parts += drawing_.part_count() - std::exchange(counted_parts_, drawing_.part_count());
}

// Draws modules that need nothing but the turtle, up to `end` or the first that does.
void PieceTurtle::draw_plain(std::size_t end)
{
    auto const* parameters = string_.parameters.data() + parameter_;
    auto const count = turtle_.draw_plain(string_.kinds.span().subspan(at_, end - at_), parameters,
                                          at_, at_ < look_from_ ? has_rules_ : stops_);
    at_ += count;
    drawn_ += count;
    parameter_ = static_cast<std::size_t>(parameters - string_.parameters.data());
}

// Draws the next module, or what the homomorphism makes of it; returns how many were read.
std::size_t PieceTurtle::draw_one()
{
    auto const kind = string_.kinds[at_];
    Modules const rest { string_.kinds.data() + at_, string_.parameters.data() + parameter_,
                         string_.size() - at_ };
    if (!has_rules_[kind]) {
        ++drawn_;
        return turtle_.draw(rest, at_, false);
    }
    machine_.begin_module(kHomomorphismStep, at_);
    Surroundings const around { &string_,   &job_.branches, at_,
                                parameter_, at_ + 1,        parameter_ + parameter_counts_[kind] };
    auto const read = homomorphism_.expand(rest, around, [&](Modules const& modules) {
        ++drawn_;
        // One module alone may become more than the limit.
        if (drawn_ % kBatch == 0 && job_.drawn + drawn_ > job_.options.max_modules)
            return std::size_t { 0 };
        return turtle_.draw(modules, at_, modules.kinds != rest.kinds);
    });
    return std::max<std::size_t>(read, 1);
}

// Leaves a long branch to another piece, if it begins here.
bool PieceTurtle::leave_out(Piece& piece)
{
    auto const long_branch = job_.options.long_branch;
    if (piece.end - at_ < 2 * long_branch) {
        look_from_ = piece.end;
        return false;
    }
    if (!turtle_.may_leave_out())
        return false;
    auto const depth = piece.depth + static_cast<std::int64_t>(turtle_.depth()) + 1;
    if (!index_->may_be_long(at_ + 1, depth))
        return false;
    auto const end = index_->find_end(at_ + 1);
    if (end.module - at_ < long_branch || end.module >= piece.end
        || piece.end - end.module < long_branch) {
        look_from_ = at_ + long_branch / 32; // Bounds what looking costs.
        return false;
    }
    drawing_.gaps.push_back({ piece.branches.size(), drawing_.axes.size(), drawing_.organs.size(),
                              drawing_.polygons.size() });
    Piece branch;
    branch.begin = at_ + 1;
    branch.end = end.module;
    branch.parameter = parameter_ + parameter_counts_[string_.kinds[at_]];
    branch.depth = depth;
    branch.start = turtle_.branch_start();
    branch.drawn.root_segment = turtle_.segment();
    piece.branches.push_back(std::move(branch));
    at_ = end.module + 1;
    parameter_ = end.parameter + parameter_counts_[string_.kinds[end.module]];
    return true;
}

// Whether pieces may be drawn in any order: no rule of the homomorphism has effects.
bool is_divisible(Model const& model)
{
    auto const& rules = model.homomorphism.rules;
    return std::none_of(rules.begin(), rules.end(), [](Rule const& rule) {
        return has_effects(rule.condition) || has_effects(rule.successor_program)
            || has_effects(rule.probability);
    });
}

bool is_finite(ModuleString const& string)
{
    std::atomic<bool> result = true;
    parallel_for(string.parameters.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
        constexpr std::uint32_t kExponent = 0x7F80'0000; // All set: not finite.
        std::uint32_t bad = 0;
        for (auto i = begin; i < end; ++i) {
            auto const bits = std::bit_cast<std::uint32_t>(string.parameters[i]);
            bad |= static_cast<std::uint32_t>((bits & kExponent) == kExponent);
        }
        if (bad != 0)
            result = false;
    });
    return result;
}

Piece whole(Job const& job)
{
    Piece piece;
    piece.end = job.string.size();
    piece.start = Turtle(job.model, job.options).start();
    return piece;
}

// Draws the string in pieces, several at a time. No value where it must be drawn from one end to
// the other: it is too short to be cut, its order matters, as it does with sub-L-systems, brackets
// do not match, or something is to be reported as it is found first.
std::optional<std::vector<Piece>> draw_in_pieces(Job& job)
{
    if (job.string.size() < 4 * job.options.long_branch || !is_divisible(job.model)
        || !job.model.subsystems.empty() || uses_patches(job.model))
        return std::nullopt;
    BranchIndex const index(job.model, job.string, job.options.long_branch);
    std::vector<Piece> pieces { whole(job) };
    for (std::size_t first = 0; first < pieces.size();) {
        auto const end = pieces.size();
        std::atomic<bool> is_good = true;
        parallel_for(end - first, 1, [&](std::size_t from, std::size_t to) {
            PieceTurtle turtle(job, &index);
            for (auto i = first + from; i < first + to; ++i) {
                turtle.draw(pieces[i]);
                if (!pieces[i].is_complete || turtle.machine().has_stopped() || job.is_over_limit())
                    is_good = false;
            }
        });
        if (!is_good)
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
    return pieces;
}

Result<std::vector<Piece>> draw_at_once(Job& job)
{
    job.drawn = job.parts = 0;
    std::vector<Piece> pieces { whole(job) };
    PieceTurtle turtle(job, nullptr);
    turtle.draw(pieces.front());
    TRY(turtle.machine().check());
    if (job.drawn > job.options.max_modules)
        return fail(Fault::User,
                    fmt::format("{}: the homomorphism makes more than {} modules", job.model.name,
                                job.options.max_modules));
    if (job.parts > job.options.max_parts)
        return fail(Fault::User,
                    fmt::format("{}: the plant has more than {} segments, organs and polygons; "
                                "derive fewer steps",
                                job.model.name, job.options.max_parts));
    return pieces;
}

// Each once, in the order of the string.
std::vector<std::string> gather_warnings(Model const& model, std::vector<Piece> const& pieces)
{
    std::vector<Drawing::Warning> all;
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

Result<TurtlePlant> draw_string(Job& job)
{
    auto const& model = job.model;
    auto const& options = job.options;
    if (std::any_of(model.homomorphism.rules.begin(), model.homomorphism.rules.end(),
                    [](Rule const& rule) { return !rule.left.empty() || !rule.right.empty(); }))
        find_branches(model, job.string, job.branches);
    job.is_finite = is_finite(job.string);
    auto in_pieces = draw_in_pieces(job);
    auto pieces = in_pieces ? std::move(*in_pieces) : TRY(draw_at_once(job));
    TurtlePlant result;
    result.warnings = gather_warnings(model, pieces);
    std::vector<DrawnPiece> drawn;
    drawn.reserve(pieces.size());
    for (auto& piece : pieces)
        drawn.push_back(std::move(piece.drawn));
    result.plant = assemble_plant(model.view, options.unit_mm, drawn);
    if (model.view.pipe_model)
        apply_pipe_model(result.plant, model.view.pipe_exponent,
                         model.view.pipe_tip_radius * options.unit_mm);
    return result;
}

} // namespace

Result<TurtlePlant> interpret_with_warnings(Model const& model, ModuleString const& string,
                                            TurtleOptions const& options)
{
    Job job { model, string, options };
    if (model.subsystems.empty())
        return draw_string(job);
    // Each sub-L-system has a homomorphism of its own.
    HomomorphismOptions how;
    how.limit.modules = options.max_modules;
    how.time = options.time;
    how.cuts = HomomorphismOptions::Cuts::KeepThoseOfTheString;
    auto const expanded = TRY(apply_homomorphism(model, string, how));
    Job expanded_job { model, expanded, options, true };
    return draw_string(expanded_job);
}

Result<Plant> interpret(Model const& model, ModuleString const& string,
                        TurtleOptions const& options)
{
    return TRY(interpret_with_warnings(model, string, options)).plant;
}

} // namespace tractus
