#include "engine/lsystem/derivation/derive.h"

#include "engine/base/parallel.h"
#include "engine/lsystem/derivation/environments.h"
#include "engine/lsystem/fast_rewriting/context_table.h"
#include "engine/lsystem/fast_rewriting/range_rewriter.h"
#include "engine/lsystem/fast_rewriting/subsystem_rewriter.h"
#include "engine/lsystem/language/print.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/core.h>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lsystem {

namespace {

// Maximum number of modules in a string: indices of modules and parameters must fit into 32 bits.
constexpr std::size_t kMaxModules = 200'000'000;

constexpr std::size_t kPiecesAtATime = 32;

// Index of a module and of its first parameter.
struct Place {
    std::size_t module = 0;
    std::size_t parameter = 0;

    void operator+=(Place const& other)
    {
        module += other.module;
        parameter += other.parameter;
    }
};

class Derivation {
public:
    Derivation(Model const& model, DeriveOptions const& options)
        : model_(model)
        , options_(options)
        , piece_(std::max<std::size_t>(options.piece, 1))
        , machine_(model, options.seed)
        , table_(ContextTable::create(model))
        , plan_(model, model)
        , rewriter_(plan_, machine_, branches_)
    {
        machine_.set_printer(&options.print);
        machine_.set_time_limit(&options.limits.time);
        machine_.set_memory_limit(options.limits.max_memory_bytes);
        if (!model.subsystems.empty())
            subsystems_.emplace(model, machine_, branches_);
        environment_ = options.environment
            ? options.environment
            : make_environment(model.view.environment, options.limits.time);
        has_queries_ = has_queries(model) || keeps_cuts(model);
    }

    Result<ModuleString> run();

private:
    // The place of a piece of the string before and after a step.
    struct PiecePlace {
        Place from; // Place of the piece's first module in in_.
        Place to;   // Place of that module's successor in out_.
    };

    Result<void> start();
    int length();
    Result<void> step(int number);
    Result<void> answer();
    template<typename Write> Result<void> rewrite_known_sizes(Write const& write);
    Result<void> rewrite_fixed();
    Result<void> rewrite_to_places();
    Result<void> rewrite();
    Result<void> rewrite_in_pieces();
    std::vector<PiecePlace> find_pieces() const;
    void write_fixed(PiecePlace const& begin, PiecePlace const& end_place);
    StringLimit limit() const;
    Result<void> check_size(std::size_t modules, std::size_t parameters) const;

    Model const& model_;
    DeriveOptions const& options_;
    std::size_t piece_;
    VirtualMachine machine_;
    std::optional<ContextTable> table_;
    RulePlan plan_;
    Branches branches_; // Matching brackets of in_; only filled if rules have contexts.
    RangeRewriter rewriter_;
    std::optional<SubsystemRewriter> subsystems_;
    Environment environment_;
    bool has_queries_ = false;
    int step_ = 0;
    ModuleString in_;
    ModuleString out_;
};

Result<ModuleString> Derivation::run()
{
    auto const steps = options_.steps.value_or(model_.steps);
    machine_.global(GlobalIndex::Steps) = steps;
    machine_.global(GlobalIndex::DerivationLength) = steps;
    TRY(start());
    TRY(check_size(in_.size(), in_.parameters.size()));
    TRY(answer());
    if (options_.on_step)
        options_.on_step(0, in_);
    for (int i = 1; i <= length(); ++i) {
        TRY(step(i));
        TRY(answer());
        if (options_.on_step)
            options_.on_step(i, in_);
    }
    machine_.begin_module(static_cast<std::uint32_t>(step_), kNoPosition - 2);
    machine_.run(model_.end);
    TRY(machine_.check());
    in_.globals = std::move(machine_.globals);
    in_.arrays = std::move(machine_.arrays);
    in_.seed = machine_.seed();
    return std::move(in_);
}

// Answers the query modules of the current string, in_.
Result<void> Derivation::answer()
{
    if (!has_queries_)
        return {};
    return answer_queries(model_, in_, machine_, step_, environment_);
}

// Returns the current number of steps; a model may change it while it is derived.
int Derivation::length()
{
    if (options_.steps)
        return *options_.steps;
    double const length = machine_.global(GlobalIndex::DerivationLength);
    return static_cast<int>(std::clamp(std::isnan(length) ? 0 : length, 0.0, 1e9));
}

Result<void> Derivation::start()
{
    machine_.begin_module(0, kNoPosition);
    machine_.run(model_.start);
    auto frame = model_.axiom_program.frame;
    machine_.run(model_.axiom_program.program, frame.data());
    TRY(machine_.check());
    auto const& axiom = model_.axiom;
    in_.kinds.append(axiom.kinds.data(), axiom.kinds.size());
    for (auto const reg : axiom.parameters) {
        auto const value = static_cast<float>(frame[reg]);
        in_.parameters.append(&value, 1);
    }
    if (subsystems_)
        TRY(subsystems_->add_calls(in_, 0, 0));
    return {};
}

Result<void> Derivation::step(int number)
{
    step_ = number;
    machine_.global(GlobalIndex::Step) = number;
    auto const stream = static_cast<std::uint32_t>(number);
    machine_.begin_module(stream, kNoPosition);
    machine_.spend(in_.size() + 1);
    machine_.run(model_.start_each);
    out_.kinds.clear();
    out_.parameters.clear();
    // A model with a context table has no parameters, so its string takes one byte per module.
    if (table_)
        table_->rewrite(in_.kinds, out_.kinds, std::min(limit().modules, limit().bytes), piece_);
    else if (plan_.is_fixed() && !subsystems_)
        TRY(rewrite_fixed());
    else
        TRY(rewrite());
    machine_.begin_module(stream, kNoPosition - 1);
    TRY(machine_.check());
    TRY(check_size(out_.size(), out_.parameters.size()));
    machine_.run(model_.end_each);
    TRY(machine_.check());
    in_.kinds.swap(out_.kinds);
    in_.parameters.swap(out_.parameters);
    in_.calls.swap(out_.calls);
    return {};
}

// Returns the size limit of the string that a step makes. The old string and its branches stay in
// memory until the step is done. Of the remaining memory only two thirds are used, because columns
// grow by half of their size.
StringLimit Derivation::limit() const
{
    auto const held = in_.byte_size()
        + (branches_.partner.capacity() + branches_.parameters.capacity()) * sizeof(std::uint32_t);
    auto const left
        = options_.limits.max_memory_bytes - std::min(held, options_.limits.max_memory_bytes);
    return { std::min(options_.limits.max_modules, kMaxModules), left / 3 * 2 };
}

Result<void> Derivation::check_size(std::size_t modules, std::size_t parameters) const
{
    auto const most = limit();
    auto const where = step_ == 0 ? std::string("the axiom") : fmt::format("step {}", step_);
    // The factor 16 keeps parameter indices within 32 bits. It has no other effect, since modules
    // seldom have that many parameters.
    if (modules > most.modules || parameters / 16 > most.modules)
        return fail(Fault::User,
                    fmt::format("{}: {} makes more than {} modules; derive fewer steps or raise "
                                "the limit of modules",
                                model_.name, where, most.modules));
    if (modules * sizeof(KindId) + parameters * sizeof(float) > most.bytes)
        return fail(Fault::User,
                    fmt::format("{}: {} needs more than {} MB of memory; derive fewer steps or "
                                "raise the limit of memory",
                                model_.name, where, options_.limits.max_memory_bytes >> 20));
    return {};
}

Result<void> Derivation::rewrite()
{
    if (subsystems_ ? subsystems_->has_contexts() : rewriter_.has_contexts())
        find_branches(model_, in_, branches_);
    if (in_.size() > 2 * piece_ && plan_.is_divisible() && thread_count() > 1 && !subsystems_)
        return plan_.has_known_sizes() ? rewrite_to_places() : rewrite_in_pieces();
    out_.kinds.reserve(in_.size());
    out_.parameters.reserve(in_.parameters.size());
    RangeRewriter::Task const task { in_, static_cast<std::uint32_t>(step_), limit(), out_ };
    if (subsystems_)
        return subsystems_->rewrite(task, step_ >= length());
    rewriter_.rewrite(task, { 0, in_.size(), 0 });
    rewriter_.rewrite_kept(task);
    return {};
}

// Rewrites several pieces at a time, each into its own string, and then concatenates the results.
Result<void> Derivation::rewrite_in_pieces()
{
    struct Piece {
        ModuleString out;
        VirtualMachine::Stop stop = VirtualMachine::Stop::None;
    };
    auto const places = find_pieces();
    auto const count = places.size() - 1;
    auto const most = limit();
    std::vector<Piece> pieces(std::min(count, kPiecesAtATime));
    for (std::size_t first = 0; first < count; first += pieces.size()) {
        auto const now = std::span(pieces).first(std::min(pieces.size(), count - first));
        parallel_for(now.size(), 1, [&](std::size_t begin, std::size_t end) {
            VirtualMachine machine = machine_;
            RangeRewriter rewriter(plan_, machine, branches_);
            for (auto i = begin; i < end; ++i) {
                auto const& place = places[first + i].from;
                now[i].out.kinds.clear();
                now[i].out.parameters.clear();
                rewriter.rewrite(
                    { in_, static_cast<std::uint32_t>(step_), most, now[i].out },
                    { place.module, places[first + i + 1].from.module, place.parameter });
                now[i].stop = machine.stop();
            }
        });
        for (auto const& piece : now)
            machine_.stop_too(piece.stop);
        TRY(machine_.check());
        std::vector<Place> to { { out_.size(), out_.parameters.size() } };
        for (auto const& piece : now)
            to.push_back({ to.back().module + piece.out.size(),
                           to.back().parameter + piece.out.parameters.size() });
        TRY(check_size(to.back().module, to.back().parameter));
        out_.grow(to.back().module, to.back().parameter);
        parallel_for(now.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i) {
                auto const& piece = now[i].out;
                std::copy_n(piece.kinds.data(), piece.size(), out_.kinds.data() + to[i].module);
                std::copy_n(piece.parameters.data(), piece.parameters.size(),
                            out_.parameters.data() + to[i].parameter);
            }
        });
    }
    return {};
}

// Returns the places at which each piece of in_ begins and, if sizes are known, at which its result
// begins in out_. The last entry is the end of both strings.
std::vector<Derivation::PiecePlace> Derivation::find_pieces() const
{
    auto const& kinds = model_.alphabet.kinds;
    std::vector<PiecePlace> places((in_.size() + piece_ - 1) / piece_ + 1);
    parallel_for(places.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const last = std::min((i + 1) * piece_, in_.size());
            auto const counts
                = count_kinds({ in_.kinds.data() + i * piece_, in_.kinds.data() + last });
            auto& place = places[i + 1];
            place.from.module = last - i * piece_;
            for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
                auto const size = plan_.size(static_cast<KindId>(kind));
                place.from.parameter += counts[kind] * kinds[kind].parameter_count;
                place.to.module += counts[kind] * size.modules;
                place.to.parameter += counts[kind] * size.parameters;
            }
        }
    });
    for (std::size_t i = 1; i < places.size(); ++i) {
        places[i].from += places[i - 1].from;
        places[i].to += places[i - 1].to;
    }
    return places;
}

// Rewrites a string whose successors all have known sizes. Computes the size of the result, then
// calls write(places) in parallel for groups of pieces. `places` has an entry for each piece of a
// group and one for the group's end.
template<typename Write> Result<void> Derivation::rewrite_known_sizes(Write const& write)
{
    auto const places = find_pieces();
    auto const& end_place = places.back().to;
    TRY(check_size(end_place.module, end_place.parameter));
    out_.grow(end_place.module, end_place.parameter);
    parallel_for(places.size() - 1, 1, [&](std::size_t begin, std::size_t end) {
        write(std::span(places).subspan(begin, end - begin + 1));
    });
    return {};
}

Result<void> Derivation::rewrite_fixed()
{
    return rewrite_known_sizes([&](std::span<PiecePlace const> places) {
        for (std::size_t i = 0; i + 1 < places.size(); ++i)
            write_fixed(places[i], places[i + 1]);
    });
}

// Rewrites a string with stochastic or parametric rules, if all successors of a kind of module have
// the same, known size.
Result<void> Derivation::rewrite_to_places()
{
    std::atomic<VirtualMachine::Stop> stop = VirtualMachine::Stop::None;
    TRY(rewrite_known_sizes([&](std::span<PiecePlace const> places) {
        VirtualMachine machine = machine_;
        RangeRewriter rewriter(plan_, machine, branches_);
        for (std::size_t i = 0; i + 1 < places.size(); ++i) {
            auto const& [from, to] = places[i];
            rewriter.rewrite_to_place(
                in_, static_cast<std::uint32_t>(step_),
                { from.module, places[i + 1].from.module, from.parameter },
                { out_.kinds.data() + to.module, out_.parameters.data() + to.parameter });
        }
        for (auto seen = stop.load();
             machine.stop() > seen && !stop.compare_exchange_weak(seen, machine.stop());) { }
    }));
    machine_.stop_too(stop);
    return {};
}

void Derivation::write_fixed(PiecePlace const& begin, PiecePlace const& end_place)
{
    auto const& [from, to] = begin;
    // Local copies of pointers: kinds are bytes, so the compiler must assume that writing them
    // changes any other object in memory.
    auto const* kind = in_.kinds.data() + from.module;
    auto const* const end = in_.kinds.data() + end_place.from.module;
    auto const* parameters = in_.parameters.data() + from.parameter;
    auto const* const successors = &plan_.fixed(0);
    ModuleWriter writer(out_.kinds.data() + to.module, out_.parameters.data() + to.parameter);
    // Wide moves must not write past the piece's end, where another thread writes the next piece.
    auto const room = end_place.to.module - to.module;
    auto const* const wide_end
        = writer.kinds + (room >= FixedSuccessor::kShort ? room - FixedSuccessor::kShort + 1 : 0);
    for (; kind != end && writer.kinds < wide_end; ++kind) {
        successors[*kind].write(parameters, writer);
        parameters += successors[*kind].read_parameter_count;
    }
    for (; kind != end; ++kind) {
        successors[*kind].write_exact_size(parameters, writer);
        parameters += successors[*kind].read_parameter_count;
    }
}

} // namespace

Result<ModuleString> derive(Model const& model, DeriveOptions const& options)
{
    return Derivation(model, options).run();
}

} // namespace tractus::lsystem
