#include "engine/lsystem/fast_rewriting/range_rewriter.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cstring>

namespace tractus::lsystem {

// Number of parameters that are copied in one wide move.
static constexpr std::size_t kWideRun = 8;

// Copies `count` values and advances `to` by `count`. If `is_wide`, copies in moves of a fixed
// width, which is faster for short runs but may write past the end.
template<std::size_t width, typename T>
static void copy_run(T const* from, std::size_t count, bool is_wide, T*& to)
{
    if (is_wide)
        for (std::size_t done = 0; done < count; done += width)
            std::memcpy(to + done, from + done, width * sizeof(T));
    else
        std::copy_n(from, count, to);
    to += count;
}

static bool is_divisible(RuleSet const& rules)
{
    return std::all_of(rules.rules.begin(), rules.rules.end(), [](Rule const& rule) {
        return rule.predecessor.size() == 1 && !rule.keeps_locals && !has_effects(rule.condition)
            && !has_effects(rule.successor_program) && !has_effects(rule.probability);
    });
}

RulePlan::RulePlan(Model const& model, LSystem const& system)
    : model_(model)
    , system_(system)
    , is_divisible_(lsystem::is_divisible(system.rules)
                    && lsystem::is_divisible(system.decomposition))
    , has_bounds_(!system.decomposition.specified)
{
    for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i) {
        auto const& kind = model.alphabet.kinds[i];
        if (kind.symbol == '%')
            is_divisible_ = has_bounds_ = false;
        most_parameters_ = std::max<std::size_t>(most_parameters_, kind.parameter_count);
        ways_[i] = find_rewrite_mode(static_cast<KindId>(i));
        is_fixed_ = is_fixed_ && (ways_[i] == Way::Copy || ways_[i] == Way::Fixed);
        has_known_sizes_ = find_size(static_cast<KindId>(i)) && has_known_sizes_;
    }
    for (auto const& rule : system.rules.rules) {
        longest_ = std::max(longest_, rule.successor.kinds.size());
        most_parameters_ = std::max(most_parameters_, rule.successor.parameters.size());
        if (rule.predecessor.size() > 1)
            has_bounds_ = false;
    }
    find_batches();
}

RulePlan::Way RulePlan::find_rewrite_mode(KindId kind)
{
    auto const& symbol = model_.alphabet[kind];
    auto const& rules = system_.rules.by_kind[kind];
    if (system_.decomposition.specified || (rules.empty() && symbol.symbol == '%'))
        return Way::Search;
    if (rules.empty()) {
        fixed_[kind] = FixedSuccessor::copy(kind, symbol.parameter_count);
        return Way::Copy;
    }
    if (!find_chances(kind))
        return Way::Search;
    auto const& first = rule(candidates_[kind].front());
    if (candidates_[kind].size() > 1 || !first.successor_program.empty())
        return Way::Chance;
    fixed_[kind] = FixedSuccessor::of(first);
    return Way::Fixed;
}

// Fills candidates_ and returns true if chance alone chooses among the kind's rules. In a
// deterministic system the first rule is the only candidate.
bool RulePlan::find_chances(KindId kind)
{
    auto& candidates = candidates_[kind];
    for (auto const number : system_.rules.by_kind[kind]) {
        auto const& rule = system_.rules.rules[number];
        if (rule.predecessor.size() > 1 || !rule.left.empty() || !rule.right.empty()
            || rule.has_condition || !rule.condition.empty() || !rule.probability.empty())
            return false;
        double const weight = rule.has_probability ? rule.frame[rule.probability_result] : 1;
        if (!system_.stochastic) {
            candidates = { { number, 1 } };
            break;
        }
        if (weight > 0) {
            candidates.push_back({ number, weight });
            total_weights_[kind] += weight;
        }
    }
    return !candidates.empty();
}

// Fills sizes_ and returns true if all successors of the kind have the same size.
bool RulePlan::find_size(KindId kind)
{
    if (ways_[kind] == Way::Copy || ways_[kind] == Way::Fixed) {
        sizes_[kind] = { fixed_[kind].length, fixed_[kind].parameter_count };
        return true;
    }
    if (ways_[kind] == Way::Search)
        return false;
    auto const size_of = [this](Candidate const& candidate) -> Size {
        auto const& successor = rule(candidate).successor;
        return { successor.kinds.size(), successor.parameters.size() };
    };
    auto const& candidates = candidates_[kind];
    auto const size = sizes_[kind] = size_of(candidates.front());
    return std::all_of(candidates.begin(), candidates.end(), [&](Candidate const& candidate) {
        auto const other = size_of(candidate);
        return other.modules == size.modules && other.parameters == size.parameters;
    });
}

// Marks the kinds whose modules may be collected and rewritten in batches, rule by rule. There are
// none if the order of modules matters.
void RulePlan::find_batches()
{
    for (std::size_t i = 0; i < model_.alphabet.kinds.size(); ++i) {
        auto const& candidates = candidates_[i];
        if (is_divisible_ && ways_[i] == Way::Chance
            && std::all_of(candidates.begin(), candidates.end(), [this](auto const& candidate) {
                   return RuleBatch::is_possible(rule(candidate));
               })) {
            ways_[i] = Way::Batch;
            has_batches_ = true;
        }
        scan_kinds_[i] = { model_.alphabet.kinds[i].parameter_count, ways_[i] != Way::Copy,
                           ways_[i] == Way::Batch && candidates.size() > 1 };
    }
}

// Returns the rule of the first candidate at which the cumulative weight exceeds `number` times the
// total weight. Without branches, since processors cannot predict chance.
std::size_t RulePlan::choose(KindId kind, double number) const
{
    auto const& candidates = candidates_[kind];
    double left = total_weights_[kind] * number;
    std::size_t chosen = 0;
    for (auto const& candidate : candidates) {
        left -= candidate.weight;
        chosen += !(left < 0);
    }
    return candidates[std::min(chosen, candidates.size() - 1)].rule;
}

RangeRewriter::RangeRewriter(RulePlan const& plan, VirtualMachine& machine,
                             Branches const& branches)
    : plan_(plan)
    , model_(plan.model())
    , system_(plan.system())
    , machine_(machine)
    , branches_(branches)
    , rewriter_(model_, system_, system_.rules, machine)
    , decomposition_(model_, system_, system_.decomposition, machine)
{
    if (plan.has_batches())
        for (auto const& rule : system_.rules.rules)
            batches_.emplace_back(rule);
}

void RangeRewriter::begin(Task const& task)
{
    in_ = &task.in;
    step_ = task.step;
    out_ = &task.out;
    limit_ = task.limit;
}

void RangeRewriter::rewrite(Task const& task, Range const& range)
{
    begin(task);
    if (plan_.has_bounds())
        rewrite_bounded(range);
    else
        rewrite_any(range);
}

std::size_t RangeRewriter::rewrite_module(Task const& task, std::size_t at, std::size_t parameter)
{
    begin(task);
    Modules const rest { in_->kinds.data() + at, in_->parameters.data() + parameter,
                         in_->size() - at };
    machine_.spend(1);
    machine_.begin_module(task.step, at);
    return rewrite_one(rest, { in_, &branches_, at, parameter, at + 1, 0 });
}

// Rewrites a range block by block; reserves memory for a whole block at once.
void RangeRewriter::rewrite_bounded(Range const& range)
{
    auto parameter = range.parameter;
    for (auto begin = range.begin; begin < range.end && !is_over(); begin += BlockScan::kMax) {
        auto const end = std::min(begin + BlockScan::kMax, range.end);
        machine_.spend(end - begin);
        out_->kinds.reserve_more((end - begin) * plan_.longest() + FixedSuccessor::kShort);
        out_->parameters.reserve_more((end - begin) * plan_.most_parameters() + kWideRun);
        ModuleWriter to(*out_);
        parameter = write_block({ begin, end, parameter }, Room::ForWideRuns, to);
        to.finish(*out_);
    }
}

// Rewrites a range of at most BlockScan::kMax modules. Returns the index of the first parameter
// after the range.
std::size_t RangeRewriter::write_block(Range const& range, Room room, ModuleWriter& to)
{
    auto const size = static_cast<std::uint32_t>(range.end - range.begin);
    auto const* const kinds = in_->kinds.data() + range.begin;
    auto const* const parameters = in_->parameters.data() + range.parameter;
    scan_.find(plan_.scan_kinds(), { kinds, size });
    scan_.draw(machine_.seed(), step_, range.begin);
    auto const end = range.parameter + scan_.parameter_count();
    bool const wide_kinds = range.end + FixedSuccessor::kShort <= in_->kinds.capacity();
    bool const wide_parameters
        = room == Room::ForWideRuns && end + kWideRun <= in_->parameters.capacity();
    // Local copy: kinds are bytes, so the compiler must assume that writing them changes any other
    // object in memory.
    auto writer = to;
    BlockScan::Change copied;
    auto const copy_until = [&](BlockScan::Change const& place) {
        copy_run<FixedSuccessor::kShort>(kinds + copied.module, place.module - copied.module,
                                         wide_kinds, writer.kinds);
        copy_run<kWideRun>(parameters + copied.parameter, place.parameter - copied.parameter,
                           wide_parameters, writer.parameters);
    };
    for (std::size_t i = 0; i < scan_.changes().size(); ++i) {
        auto const change = scan_.changes()[i];
        copy_until(change);
        auto const kind = kinds[change.module];
        auto const* const from = parameters + change.parameter;
        if (plan_.way(kind) == RulePlan::Way::Batch) {
            batches_[plan_.choose(kind, scan_.number(i))].add(from, writer);
        } else if (plan_.way(kind) == RulePlan::Way::Fixed) {
            plan_.fixed(kind).write(from, writer);
        } else {
            to = writer;
            rewrite_one_bounded(range.begin + change.module, range.parameter + change.parameter,
                                to);
            writer = to;
        }
        copied = { change.module + 1, change.parameter + plan_.scan_kinds()[kind].parameter_count };
    }
    copy_until({ size, scan_.parameter_count() });
    for (auto& batch : batches_)
        batch.finish();
    to = writer;
    return end;
}

// Rewrites a range of any size block by block. Returns the index of the first parameter after the
// range.
std::size_t RangeRewriter::write_blocks(Range const& range, Room room, ModuleWriter& to)
{
    auto parameter = range.parameter;
    for (auto begin = range.begin; begin < range.end && !machine_.has_stopped();
         begin += BlockScan::kMax) {
        auto const end = std::min(begin + BlockScan::kMax, range.end);
        machine_.spend(end - begin);
        parameter = write_block({ begin, end, parameter }, room, to);
    }
    return parameter;
}

void RangeRewriter::rewrite_to_place(ModuleString const& in, std::uint32_t step, Range const& range,
                                     ModuleWriter to)
{
    constexpr std::size_t kLongTail = 64;
    in_ = &in;
    step_ = step;
    // Wide moves write past the end of a run; after the range's end another thread may be writing.
    // The successors of the last modules are therefore first written to a buffer.
    RulePlan::Size last;
    auto tail = range.end;
    while (tail > range.begin
           && (last.modules < FixedSuccessor::kShort
               || (last.parameters < kWideRun && range.end - tail < kLongTail))) {
        auto const size = plan_.size(in.kinds[--tail]);
        last = { last.modules + size.modules, last.parameters + size.parameters };
    }
    auto const room = last.parameters < kWideRun ? Room::Tight : Room::ForWideRuns;
    auto const parameter = write_blocks({ range.begin, tail, range.parameter }, room, to);
    if (machine_.has_stopped())
        return;
    successor_.kinds.reserve(last.modules + FixedSuccessor::kShort);
    successor_.parameters.reserve(last.parameters + kWideRun);
    ModuleWriter buffer(successor_.kinds.data(), successor_.parameters.data());
    write_blocks({ tail, range.end, parameter }, Room::ForWideRuns, buffer);
    if (machine_.has_stopped())
        return;
    std::copy_n(successor_.kinds.data(), last.modules, to.kinds);
    std::copy_n(successor_.parameters.data(), last.parameters, to.parameters);
}

void RangeRewriter::rewrite_one_bounded(std::size_t at, std::size_t parameter, ModuleWriter& to)
{
    auto const kind = in_->kinds[at];
    Modules const rest { in_->kinds.data() + at, in_->parameters.data() + parameter,
                         in_->size() - at };
    machine_.begin_module(step_, at);
    if (plan_.way(kind) == RulePlan::Way::Chance) {
        auto const number = plan_.has_chance(kind) ? machine_.uniform() : 0;
        auto const& rule = system_.rules.rules[plan_.choose(kind, number)];
        rewriter_.load_predecessor(rule, rest.parameters);
        return rewriter_.apply(rule, to);
    }
    if (auto const* const rule
        = rewriter_.find(rest, { in_, &branches_, at, parameter, at + 1, 0 }, true))
        return rewriter_.apply(*rule, to);
    FixedSuccessor::copy(kind, model_.alphabet[kind].parameter_count).write(rest.parameters, to);
}

void RangeRewriter::rewrite_any(Range const& range)
{
    auto parameter = range.parameter;
    for (auto i = range.begin; i < range.end && !is_over();) {
        Modules const rest { in_->kinds.data() + i, in_->parameters.data() + parameter,
                             in_->size() - i };
        machine_.spend(1);
        machine_.begin_module(step_, i);
        auto const count = rewrite_one(rest, { in_, &branches_, i, parameter, i + 1, 0 });
        for (std::size_t k = 0; k < count; ++k)
            parameter += model_.alphabet[rest.kinds[k]].parameter_count;
        i += count;
    }
}

// Appends the successor of the first module of `rest`. Returns the number of modules read.
std::size_t RangeRewriter::rewrite_one(Modules const& rest, Surroundings const& around)
{
    auto const kind = rest.kinds[0];
    auto const* const rule
        = rewriter_.has_rules(kind) ? rewriter_.find(rest, around, true) : nullptr;
    if (rule && !system_.decomposition.specified) {
        rewriter_.apply(*rule, *out_);
        return rule->predecessor.size();
    }
    if (rule) {
        successor_.kinds.clear();
        successor_.parameters.clear();
        rewriter_.apply(*rule, successor_);
        decompose_successor(around, rule->predecessor.size());
        return rule->predecessor.size();
    }
    auto const symbol = model_.alphabet[kind];
    if (decomposition_.has_rules(kind)) {
        auto beyond = around;
        beyond.right_parameters = around.left_parameters + symbol.parameter_count;
        bool decomposed = true;
        auto const count
            = decomposition_.expand(rest, beyond, [&](Modules const& modules) -> std::size_t {
                  decomposed = modules.kinds != rest.kinds;
                  if (decomposed)
                      append_one(modules);
                  return !is_over();
              });
        if (decomposed)
            return std::max<std::size_t>(count, 1);
    }
    if (symbol.symbol == '%' && symbol.parameter_count < 2) {
        auto const end = cut_end(model_, *in_, around.left + 1);
        if (symbol.parameter_count == 1)
            keep({ around.left + 1, end, around.left_parameters + 1 });
        return end - around.left;
    }
    append_one(rest);
    return 1;
}

void RangeRewriter::decompose_successor(Surroundings const& around, std::size_t predecessor_length)
{
    auto beyond = around;
    beyond.right = around.left + predecessor_length;
    beyond.right_parameters = around.left_parameters;
    for (auto i = around.left; i < beyond.right; ++i)
        beyond.right_parameters += model_.alphabet[in_->kinds[i]].parameter_count;
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < successor_.size();) {
        Modules const rest { successor_.kinds.data() + i, successor_.parameters.data() + parameter,
                             successor_.size() - i };
        std::size_t count = 1;
        if (decomposition_.has_rules(rest.kinds[0]))
            count = decomposition_.expand(rest, beyond, [&](Modules const& modules) -> std::size_t {
                append_one(modules);
                return !is_over();
            });
        else
            append_one(rest);
        if (count == 0)
            return; // The string has too many modules, which the caller reports.
        for (std::size_t k = 0; k < count; ++k)
            parameter += model_.alphabet[rest.kinds[k]].parameter_count;
        i += count;
    }
}

// Records the range of a branch that the %(x) before it has cut off.
void RangeRewriter::keep(Range const& range)
{
    auto const& cuts = in_->cuts;
    auto const cut = std::lower_bound(
        cuts.begin(), cuts.end(), range.begin - 1,
        [](KeptCut const& other, std::size_t module) { return other.module < module; });
    if (cut != cuts.end() && cut->module == range.begin - 1)
        kept_.push_back({ range, cut->turtle });
}

void RangeRewriter::rewrite_kept(Task const& task)
{
    begin(task);
    auto const kind = find_kind(model_.alphabet, { '%', 2 });
    // The loop's bound may grow while it runs, since kept branches may contain further cuts.
    for (std::size_t i = 0; i < kept_.size() && !is_over(); ++i) {
        auto const [range, turtle] = kept_[i];
        CHECK(kind);
        out_->kinds.append(&*kind, 1);
        out_->parameters.append(in_->parameters.data() + range.parameter - 1, 1);
        auto const number = static_cast<float>(turtle);
        out_->parameters.append(&number, 1);
        rewrite_any(range);
    }
    kept_.clear();
}

void RangeRewriter::append_one(Modules const& modules)
{
    out_->kinds.append(modules.kinds, 1);
    out_->parameters.append(modules.parameters, model_.alphabet[modules.kinds[0]].parameter_count);
}

} // namespace tractus::lsystem
