#include "engine/lsystem/fast_drawing/piece_turtle.h"

#include "engine/base/check.h"
#include "engine/lsystem/rewriting/homomorphism.h"

#include <algorithm>
#include <utility>

namespace tractus::lsystem {

// Number of modules to draw between two checks of the limits.
static constexpr std::size_t kDrawnBatch = 1024;

// Maximum memory of a drawing, as a multiple of its size: the array itself, the array of twice the
// size into which it grows, and the copy from which the plant is assembled.
static constexpr std::size_t kHeldTimes = 4;

PieceTurtle::PieceTurtle(DrawingJob& job, BranchIndex const* index)
    : job_(job)
    , model_(job.model)
    , string_(job.string)
    , machine_(job.model, job.string)
    , homomorphism_(job.model, job.model.homomorphism, machine_)
    , turtle_(job.model, job.options)
{
    turtle_.set_kept(string_.turtles);
    if (index)
        cutter_.emplace(*index);
    machine_.set_time_limit(&job.options.time);
    machine_.set_memory_limit(job.options.max_memory_bytes);
    machine_.set_printer(&job.options.print);
    for (std::size_t i = 0; i < model_.alphabet.kinds.size(); ++i) {
        has_rules_[i] = !job.is_expanded && homomorphism_.has_rules(static_cast<KindId>(i));
        opens_[i] = model_.alphabet.kinds[i].symbol == '[' && !has_rules_[i];
        stops_[i] = has_rules_[i] || (index && opens_[i]);
        parameter_counts_[i] = model_.alphabet.kinds[i].parameter_count;
    }
}

void PieceTurtle::begin(Piece const& piece)
{
    drawing_.clear();
    drawing_.target = piece.target;
    turtle_.begin(piece.start, drawing_);
    at_ = piece.begin;
    parameter_ = piece.parameter;
    counted_parts_ = counted_bytes_ = 0;
}

void PieceTurtle::end(Piece& piece)
{
    count();
    piece.drawn.drawing = drawing_.copy(job_.memory);
    piece.is_complete = turtle_.is_complete() && at_ == piece.end;
}

void PieceTurtle::draw(Piece& piece)
{
    begin(piece);
    look_from_ = cutter_ ? piece.begin : piece.end;
    if (cutter_)
        cutter_->begin(piece.begin, piece.end);
    while (at_ < piece.end) {
        if (cutter_ && at_ >= look_from_)
            look_from_ = cutter_->look_from(at_);
        auto const end = at_ < look_from_ ? std::min(piece.end, look_from_) : piece.end;
        draw_plain(end, at_ < look_from_ ? has_rules_ : stops_);
        if (at_ == piece.end)
            break;
        if (opens_[string_.kinds[at_]] && at_ >= look_from_ && leave_out(piece))
            continue;
        if (!draw_next())
            return;
    }
    end(piece);
}

void PieceTurtle::draw(std::vector<PlannedPiece> const& plan, std::size_t index,
                       std::vector<Piece>& pieces)
{
    auto& piece = pieces[index];
    begin(piece);
    for (auto const& gap : plan[index].gaps) {
        if (!draw_to(gap.opening))
            return;
        leave_out(plan[gap.piece], gap.piece, pieces[gap.piece]);
    }
    if (!draw_to(piece.end))
        return;
    CHECK(drawing_.target.axis_lengths.empty());
    end(piece);
}

// Draws the modules before index `end`. Returns false if a limit is reached.
bool PieceTurtle::draw_to(std::size_t end)
{
    while (at_ < end) {
        draw_plain(end, has_rules_);
        if (at_ < end && !draw_next())
            return false;
    }
    return true;
}

void PieceTurtle::count()
{
    job_.drawn += std::exchange(drawn_, 0);
    job_.parts += drawing_.part_count() - std::exchange(counted_parts_, drawing_.part_count());
    auto const bytes = kHeldTimes * drawing_.byte_size();
    job_.bytes += bytes - std::exchange(counted_bytes_, bytes);
}

// Draws a run of modules that need nothing but the turtle. The run ends at index `end`, at the
// first other module, or after kDrawnBatch modules.
void PieceTurtle::draw_plain(std::size_t end, std::array<bool, 256> const& stops)
{
    if (!job_.is_finite)
        return;
    auto const* parameters = string_.parameters.data() + parameter_;
    auto const most = std::min(end - at_, kDrawnBatch);
    auto const count
        = turtle_.draw_plain(string_.kinds.span().subspan(at_, most), parameters, at_, stops);
    at_ += count;
    drawn_ += count;
    parameter_ = static_cast<std::size_t>(parameters - string_.parameters.data());
}

// Draws the next module, of any kind. Returns false if a limit is reached.
bool PieceTurtle::draw_next()
{
    pass(draw_one());
    if (turtle_.take_cut())
        pass(cut_end(model_, string_, at_) - at_);
    if (drawn_ < kDrawnBatch)
        return true;
    count();
    return !job_.is_over_limit() && !machine_.has_stopped();
}

// Draws the next module or its homomorphic image. Returns the number of modules read.
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
        // A single module may expand to more modules than the limit allows, so the limits are
        // checked here.
        if (drawn_ >= kDrawnBatch) {
            count();
            if (job_.is_over_limit())
                return std::size_t { 0 };
        }
        return turtle_.draw(modules, at_, modules.kinds != rest.kinds);
    });
    return std::max<std::size_t>(read, 1);
}

// Leaves the branch that begins at the next module to another piece if it is long.
bool PieceTurtle::leave_out(Piece& piece)
{
    if (!turtle_.may_skip_branch())
        return false;
    auto const depth = piece.depth + static_cast<std::int64_t>(turtle_.depth()) + 1;
    auto const end = cutter_->cut(at_, depth);
    if (!end) {
        look_from_ = cutter_->look_from(at_);
        return false;
    }
    drawing_.gaps.push_back({ piece.branches.size(), drawing_.axes.size(), drawing_.organs.size(),
                              drawing_.polygons.size() });
    Piece branch;
    branch.begin = at_ + 1;
    branch.end = end->module;
    branch.parameter = parameter_ + parameter_counts_[string_.kinds[at_]];
    branch.depth = depth;
    branch.start = turtle_.branch_start();
    branch.drawn.root_segment = turtle_.segment();
    piece.branches.push_back(std::move(branch));
    at_ = end->module + 1;
    parameter_ = end->parameter + parameter_counts_[string_.kinds[end->module]];
    return true;
}

// Leaves the branch that begins at the next module to the piece planned for it.
void PieceTurtle::leave_out(PlannedPiece const& planned, std::size_t index, Piece& branch)
{
    drawing_.gaps.push_back({ index, 0, drawing_.organs.size(), drawing_.polygons.size() });
    branch.begin = planned.begin;
    branch.end = planned.end;
    branch.parameter = parameter_ + parameter_counts_[string_.kinds[at_]];
    branch.start = turtle_.branch_start();
    auto& target = drawing_.target;
    branch.target = target;
    branch.target.axis_lengths = planned.axis_lengths;
    target.next_axis += static_cast<AxisId>(planned.axis_count);
    target.next_segment += static_cast<SegmentId>(planned.segment_count);
    at_ = planned.end + 1;
    parameter_ = planned.end_parameter + parameter_counts_[string_.kinds[planned.end]];
}

} // namespace tractus::lsystem
