#include "engine/lsystem/fast_drawing/segment_plan.h"

#include "engine/base/parallel.h"
#include "engine/lsystem/language/print.h"
#include "engine/lsystem/language/turtle_symbols.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <span>
#include <string_view>

namespace tractus::lsystem {

namespace {

// Effect of a symbol on the number of segments.
enum class Effect : std::uint8_t {
    None,
    Draw,
    Move,
    Push,
    Pop,
    BeginPolygon,
    EndPolygon,
    Long,   // A symbol of several modules, which may have no effect.
    Unclear // A symbol whose effect is too complicated to count.
};

// Plain: all steps of the string have non-zero lengths and stay within the turtle's bounds. Any:
// some may not.
enum class StepLengths { Plain, Any };

// Maximum distance of the turtle from its start for a plan; slightly less than the turtle's bounds.
constexpr double kMaxReachMm = 0.9e12;

Effect effect_of(ModuleKind const& kind)
{
    switch (turtle_symbol(kind.symbol).does) {
    case SymbolAction::Draw:
        return Effect::Draw;
    case SymbolAction::Move:
        return Effect::Move;
    case SymbolAction::Push:
        return Effect::Push;
    case SymbolAction::Pop:
        return Effect::Pop;
    case SymbolAction::BeginPath: // A `{` with a parameter may begin a generalised cylinder.
        return kind.parameter_count == 0 ? Effect::BeginPolygon : Effect::Unclear;
    case SymbolAction::EndPath:
        return kind.parameter_count == 0 ? Effect::EndPolygon : Effect::Unclear;
    case SymbolAction::At:
    case SymbolAction::Organ:
    case SymbolAction::Call:
        return Effect::Long;
    case SymbolAction::Cut:
        return Effect::Unclear;
    default:
        return Effect::None;
    }
}

// Returns true if these modules draw no segments and do not move the turtle, whatever follows them.
bool are_plain(Alphabet const& alphabet, std::span<KindId const> kinds)
{
    while (!kinds.empty()) {
        auto const effect = effect_of(alphabet[kinds[0]]);
        auto const length = symbol_length(alphabet, kinds);
        if (effect != Effect::None && effect != Effect::Long)
            return false;
        if (effect == Effect::Long && length == 1)
            return false;
        if (turtle_symbol(alphabet[kinds[0]].symbol).does == SymbolAction::At
            && !at_symbol(alphabet[kinds[1]].symbol).is_plain)
            return false;
        kinds = kinds.subspan(length);
    }
    return true;
}

// Counts the segments of pieces, one piece after another. Each thread needs its own counter.
class SegmentCounter {
public:
    SegmentCounter(Model const& model, ModuleString const& string, TurtleOptions const& options,
                   BranchIndex const& index)
        : alphabet_(model.alphabet)
        , string_(string)
        , scale_(model.view.scale)
        , unit_mm_(options.unit_mm)
        , index_(index)
        , cutter_(index)
    {
        for (std::size_t i = 0; i < alphabet_.kinds.size(); ++i) {
            auto const& kind = alphabet_.kinds[i];
            auto const& behind_at = at_symbol(kind.symbol);
            bool const is_at = turtle_symbol(kind.symbol).does == SymbolAction::At;
            steps_[i]
                = { effect_of(kind), kind.parameter_count, is_at && kind.parameter_count == 0 };
            is_plain_second_[i] = behind_at.is_plain && behind_at.thirds.empty();
        }
    }

    // Returns false if the piece cannot be counted. Branches that are left out of the piece are
    // appended to `branches` and recorded as its gaps. With StepLengths::Any, the length of each
    // step is checked.
    bool count(PlannedPiece& piece, StepLengths lengths, std::vector<PlannedPiece>& branches);

    // Returns an upper bound of the turtle's distance from its start; 0 if step lengths were not
    // checked.
    double reach_mm() const { return reach_mm_; }

private:
    // Value of Walk::axis if the next segment begins a new axis.
    static constexpr std::uint32_t kClosed = kNone;

    struct Step {
        Effect effect = Effect::None;
        std::uint8_t parameters = 0;
        bool is_bare_at = false; // True for an @ without parameters.
    };

    // State of a count. It is a local variable while modules are counted, since in memory each
    // module would have to wait for the writes of the one before it.
    struct Walk {
        std::size_t at = 0;
        // Index of the module's first parameter; only maintained if step lengths are checked.
        std::size_t parameter = 0;
        std::size_t axis_count = 0; // Number of axes in the piece so far.
        // Bracket depth at the module, counted from the beginning of the piece.
        std::size_t depth = 0;
        std::size_t open_polygons = 0;
        double reach_mm = 0;
        std::uint32_t axis = kClosed; // Axis that the next segment continues, or kClosed.
    };

    template<StepLengths kLengths>
    bool count_modules(PlannedPiece& piece, std::vector<PlannedPiece>& branches);
    template<StepLengths kLengths> bool apply(Effect effect, Walk& walk);
    template<StepLengths kLengths> void step(bool draws, Walk& walk);
    template<StepLengths kLengths> void pass(std::size_t count, Walk& walk) const;
    std::size_t plain_length(std::size_t at) const;
    bool leave_out(PlannedPiece& piece, std::size_t at, std::size_t depth,
                   std::vector<PlannedPiece>& branches);

    Alphabet const& alphabet_;
    ModuleString const& string_;
    double scale_;
    double unit_mm_;
    BranchIndex const& index_;
    BranchCutter cutter_;
    std::array<Step, 256> steps_ {};
    // For each kind, whether it makes a symbol of two modules without effect on segments if it
    // follows an @.
    std::array<bool, 256> is_plain_second_ {};
    Column<std::uint32_t> lengths_; // Number of segments of each axis of the piece.
    // For each open bracket, the axis to continue after its closing bracket.
    Column<std::uint32_t> stack_;
    double reach_mm_ = 0;
};

bool SegmentCounter::count(PlannedPiece& piece, StepLengths lengths,
                           std::vector<PlannedPiece>& branches)
{
    lengths_.clear();
    // The number of modules is an upper bound of the sizes of both arrays.
    lengths_.reserve(piece.end - piece.begin);
    stack_.reserve(piece.end - piece.begin);
    cutter_.begin(piece.begin, piece.end);
    return lengths == StepLengths::Plain ? count_modules<StepLengths::Plain>(piece, branches)
                                         : count_modules<StepLengths::Any>(piece, branches);
}

template<StepLengths kLengths>
bool SegmentCounter::count_modules(PlannedPiece& piece, std::vector<PlannedPiece>& branches)
{
    Walk walk;
    walk.at = piece.begin;
    if (kLengths == StepLengths::Any)
        walk.parameter = index_.parameter(piece.begin);
    while (walk.at < piece.end) {
        auto const effect = steps_[string_.kinds[walk.at]].effect;
        if (effect == Effect::None) {
            pass<kLengths>(1, walk);
        } else if (effect == Effect::Long) {
            // Fast path for the most frequent case.
            bool const is_quick = steps_[string_.kinds[walk.at]].is_bare_at
                && walk.at + 1 < string_.size() && is_plain_second_[string_.kinds[walk.at + 1]];
            auto const length = is_quick ? 2 : plain_length(walk.at);
            if (length == 0)
                return false;
            pass<kLengths>(length, walk);
        } else if (effect == Effect::Push && walk.at >= cutter_.look_from(walk.at)
                   && walk.open_polygons == 0 && leave_out(piece, walk.at, walk.depth, branches)) {
            walk.at = branches.back().end + 1;
            if (kLengths == StepLengths::Any)
                walk.parameter = index_.parameter(walk.at);
        } else {
            if (!apply<kLengths>(effect, walk))
                return false;
            pass<kLengths>(1, walk);
        }
    }
    piece.axis_lengths.assign(lengths_.data(), lengths_.data() + walk.axis_count);
    reach_mm_ += walk.reach_mm;
    return walk.depth == 0 && walk.open_polygons == 0 && walk.at == piece.end;
}

// Returns the number of modules of an organ or another symbol of several modules; 0 if it may
// affect segments.
std::size_t SegmentCounter::plain_length(std::size_t at) const
{
    auto const kinds = string_.kinds.span().subspan(at);
    auto const length = symbol_length(alphabet_, kinds);
    return are_plain(alphabet_, kinds.first(length)) ? length : 0;
}

template<StepLengths kLengths> void SegmentCounter::pass(std::size_t count, Walk& walk) const
{
    if (kLengths == StepLengths::Any)
        for (std::size_t i = 0; i < count; ++i)
            walk.parameter += steps_[string_.kinds[walk.at + i]].parameters;
    walk.at += count;
}

template<StepLengths kLengths> bool SegmentCounter::apply(Effect effect, Walk& walk)
{
    switch (effect) {
    case Effect::Draw:
    case Effect::Move:
        step<kLengths>(effect == Effect::Draw, walk);
        return true;
    case Effect::Push:
        stack_.data()[walk.depth++] = walk.axis;
        walk.axis = kClosed;
        return true;
    case Effect::Pop:
        if (walk.depth == 0)
            return false;
        walk.axis = stack_.data()[--walk.depth];
        return true;
    case Effect::BeginPolygon:
        ++walk.open_polygons;
        return true;
    case Effect::EndPolygon:
        return walk.open_polygons-- > 0;
    default:
        return false;
    }
}

// Counts what Turtle::step() would draw.
template<StepLengths kLengths> void SegmentCounter::step(bool draws, Walk& walk)
{
    if (kLengths == StepLengths::Any) {
        double const length = steps_[string_.kinds[walk.at]].parameters > 0
            ? static_cast<double>(string_.parameters[walk.parameter])
            : 1;
        double const length_mm = length * scale_ * unit_mm_;
        walk.reach_mm += std::abs(length_mm);
        if (length_mm == 0)
            return;
    }
    if (walk.open_polygons > 0)
        return;
    auto* const lengths = lengths_.data();
    if (draws && walk.axis == kClosed) {
        walk.axis = static_cast<std::uint32_t>(walk.axis_count++);
        lengths[walk.axis] = 1;
    } else if (draws) {
        ++lengths[walk.axis];
    } else {
        walk.axis = kClosed;
    }
}

// Leaves a branch that begins at module `at` to another piece, which is appended to `branches`.
// Returns false if the branch is not long enough.
bool SegmentCounter::leave_out(PlannedPiece& piece, std::size_t at, std::size_t depth,
                               std::vector<PlannedPiece>& branches)
{
    auto const depth_inside = piece.depth + static_cast<std::int64_t>(depth) + 1;
    auto const end = cutter_.cut(at, depth_inside);
    if (!end)
        return false;
    piece.gaps.push_back({ at, branches.size() });
    PlannedPiece branch;
    branch.begin = at + 1;
    branch.end = end->module;
    branch.end_parameter = end->parameter;
    branch.depth = depth_inside;
    branches.push_back(std::move(branch));
    return true;
}

// Returns true if homomorphism rules neither make nor replace symbols that affect segments.
bool has_plain_homomorphism(Model const& model)
{
    auto const& rules = model.homomorphism.rules;
    return std::all_of(rules.begin(), rules.end(), [&](Rule const& rule) {
        return are_plain(model.alphabet, rule.successor.kinds)
            && std::all_of(rule.predecessor.begin(), rule.predecessor.end(), [&](KindId kind) {
                   return effect_of(model.alphabet[kind]) == Effect::None;
               });
    });
}

// Decides whether step lengths must be checked, since a step of zero length, or beyond the turtle's
// bounds, draws nothing.
StepLengths step_lengths(Model const& model, ModuleString const& string,
                         TurtleOptions const& options, ParameterRange const& range)
{
    double const unit_mm = std::abs(model.view.scale * options.unit_mm);
    double const reach_mm = std::max(1.0, static_cast<double>(range.greatest)) * unit_mm
        * static_cast<double>(string.size());
    return !range.has_zero && unit_mm > 1e-100 && reach_mm < kMaxReachMm ? StepLengths::Plain
                                                                         : StepLengths::Any;
}

// Appends the branches that each piece from `first` on has left out to the end of `pieces`.
void append_branches(std::vector<PlannedPiece>& pieces, std::size_t first,
                     std::vector<std::vector<PlannedPiece>>& branches)
{
    for (std::size_t i = 0; i < branches.size(); ++i) {
        for (auto& gap : pieces[first + i].gaps)
            gap.piece += pieces.size();
        std::move(branches[i].begin(), branches[i].end(), std::back_inserter(pieces));
    }
}

void add_totals(std::vector<PlannedPiece>& pieces)
{
    for (auto piece = pieces.rbegin(); piece != pieces.rend(); ++piece) {
        piece->axis_count = piece->axis_lengths.size();
        for (auto const length : piece->axis_lengths)
            piece->segment_count += length;
        for (auto const& gap : piece->gaps) {
            piece->axis_count += pieces[gap.piece].axis_count;
            piece->segment_count += pieces[gap.piece].segment_count;
        }
    }
}

} // namespace

ParameterRange parameter_range(ModuleString const& string)
{
    // The magnitudes of floats compare like their bit patterns; NaN is greater than all.
    std::atomic<bool> has_zero = false;
    std::atomic<std::int32_t> greatest = 0;
    parallel_for(string.parameters.size(), 1 << 16, [&](std::size_t begin, std::size_t end) {
        std::int32_t high = 0;
        std::int32_t zeros = 0;
        for (auto i = begin; i < end; ++i) {
            auto const bits = std::bit_cast<std::int32_t>(string.parameters[i]) & 0x7FFF'FFFF;
            high = bits > high ? bits : high;
            zeros |= static_cast<std::int32_t>(bits == 0);
        }
        if (zeros != 0)
            has_zero = true;
        for (auto seen = greatest.load();
             high > seen && !greatest.compare_exchange_weak(seen, high);) { }
    });
    constexpr auto kInfinite = std::bit_cast<std::int32_t>(std::numeric_limits<float>::infinity());
    return { has_zero, std::bit_cast<float>(std::min(greatest.load(), kInfinite)) };
}

std::optional<std::vector<PlannedPiece>>
plan_segments(Model const& model, ModuleString const& string, TurtleOptions const& options,
              BranchIndex const& index, ParameterRange const& parameters)
{
    // Surfaces move the turtle, so strings of models with surfaces are not counted.
    if (!parameters.are_finite() || !model.view.surfaces.empty() || !has_plain_homomorphism(model))
        return std::nullopt;
    auto const lengths = step_lengths(model, string, options, parameters);
    std::vector<PlannedPiece> pieces(1);
    pieces[0].end = string.size();
    std::atomic<bool> is_good = true;
    std::atomic<double> reach_mm = 0;
    for (std::size_t first = 0; first < pieces.size() && is_good;) {
        auto const count = pieces.size() - first;
        std::vector<std::vector<PlannedPiece>> branches(count);
        parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
            SegmentCounter counter(model, string, options, index);
            for (auto i = begin; i < end; ++i)
                if (!counter.count(pieces[first + i], lengths, branches[i]))
                    is_good = false;
            reach_mm.fetch_add(counter.reach_mm());
        });
        append_branches(pieces, first, branches);
        first += count;
    }
    if (!is_good || pieces.size() == 1 || !(reach_mm < kMaxReachMm))
        return std::nullopt;
    add_totals(pieces);
    return pieces;
}

} // namespace tractus::lsystem
