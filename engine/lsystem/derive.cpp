#include "engine/lsystem/derive.h"

#include "engine/lsystem/expander.h"

#include <array>
#include <fmt/core.h>

namespace tractus {

namespace {

// Places in a string are 32-bit numbers, of parameters too.
constexpr std::size_t kMaxModules = 200'000'000;

// What becomes of all modules of one kind, where that is always the same: a string of modules whose
// parameters are constants or parameters of the module. Short ones are copied in one move.
struct FixedSuccessor {
    static constexpr std::size_t kShort = 16;

    bool is_fixed = false; // Else the rest has no meaning.
    std::array<KindId, kShort> first_kinds {};
    std::uint32_t length = 0;
    std::uint32_t parameter_count = 0;      // Of the successor.
    std::uint32_t read_parameter_count = 0; // Of the module.
    KindId const* kinds = nullptr;
    Register const* parameters = nullptr;
    double const* frame = nullptr;

    // Writes it for a module whose parameters are at `from`; `to_kinds` must have room for kShort.
    void write(float const* from, KindId*& to_kinds, float*& to_parameters) const
    {
        if (length <= kShort)
            std::memcpy(to_kinds, first_kinds.data(), kShort);
        else
            std::memcpy(to_kinds, kinds, length);
        to_kinds += length;
        for (std::uint32_t i = 0; i < parameter_count; ++i) {
            auto const reg = parameters ? parameters[i] : static_cast<Register>(i);
            *to_parameters++
                = reg < read_parameter_count ? from[reg] : static_cast<float>(frame[reg]);
        }
    }
};

class Derivation {
public:
    Derivation(Model const& model, DeriveOptions const& options)
        : model_(model)
        , options_(options)
        , machine_(model, options.seed)
        , rewriter_(model, model.rules, machine_, model.stochastic)
        , decomposition_(model, model.decomposition, machine_)
    {
        for (std::size_t i = 0; i < model.alphabet.kinds.size(); ++i) {
            fixed_[i].is_fixed = set_fixed(static_cast<KindId>(i));
            all_fixed_ = all_fixed_ && fixed_[i].is_fixed;
        }
    }

    Result<ModuleString> run();

private:
    bool set_fixed(KindId kind);
    void start();
    Result<void> step(int number);
    Result<void> rewrite_fixed();
    Result<void> rewrite(std::uint32_t step);
    std::size_t rewrite_one(Modules const& rest, Surroundings const& around);
    void decompose_successor(Surroundings const& around, std::size_t predecessor_length);
    void append_one(Modules const& modules);
    void append_fixed(FixedSuccessor const& fixed, float const* from);
    Result<void> check_size(std::size_t modules, std::size_t parameters) const;

    Model const& model_;
    DeriveOptions const& options_;
    Machine machine_;
    Rewriter rewriter_;
    Expander decomposition_;
    std::array<FixedSuccessor, 256> fixed_ {};
    bool all_fixed_ = true;
    int step_ = 0;
    ModuleString in_;
    ModuleString out_;
    Branches branches_;      // Of in_, where rules have contexts.
    ModuleString successor_; // Of one rule, before decomposition.
};

// Whether the kind always becomes the same; if so, fills fixed_.
bool Derivation::set_fixed(KindId kind)
{
    auto const count = model_.alphabet[kind].parameter_count;
    auto& fixed = fixed_[kind];
    fixed.read_parameter_count = count;
    auto const& rules = model_.rules.by_kind[kind];
    if (model_.decomposition.specified || rules.size() > 1
        || (rules.empty() && model_.alphabet[kind].symbol == '%'))
        return false;
    if (rules.empty()) {
        fixed.first_kinds[0] = kind;
        fixed.length = 1;
        fixed.parameter_count = count;
        return true;
    }
    auto const& rule = model_.rules.rules[rules.front()];
    if (rule.predecessor.size() > 1 || !rule.left.empty() || !rule.right.empty()
        || rule.has_condition || !rule.condition.empty() || !rule.successor_program.empty())
        return false;
    fixed.length = static_cast<std::uint32_t>(rule.successor.kinds.size());
    fixed.parameter_count = static_cast<std::uint32_t>(rule.successor.parameters.size());
    fixed.kinds = rule.successor.kinds.data();
    fixed.parameters = rule.successor.parameters.data();
    fixed.frame = rule.frame.data();
    std::copy_n(fixed.kinds, std::min<std::size_t>(fixed.length, FixedSuccessor::kShort),
                fixed.first_kinds.begin());
    return true;
}

Result<ModuleString> Derivation::run()
{
    auto const steps = options_.steps.value_or(model_.steps);
    machine_.globals[1] = steps;
    start();
    TRY(check_size(in_.size(), in_.parameters.size()));
    for (int i = 1; i <= steps; ++i)
        TRY(step(i));
    machine_.begin_module(static_cast<std::uint32_t>(step_), kNoPosition - 2);
    machine_.run(model_.end);
    TRY(machine_.check());
    in_.globals = std::move(machine_.globals);
    in_.arrays = std::move(machine_.arrays);
    in_.seed = machine_.seed();
    return std::move(in_);
}

void Derivation::start()
{
    machine_.begin_module(0, kNoPosition);
    machine_.run(model_.start);
    auto frame = model_.axiom_program.frame;
    machine_.run(model_.axiom_program.program, frame.data());
    auto const& axiom = model_.axiom;
    in_.kinds.append(axiom.kinds.data(), axiom.kinds.size());
    for (auto const reg : axiom.parameters) {
        auto const value = static_cast<float>(frame[reg]);
        in_.parameters.append(&value, 1);
    }
}

Result<void> Derivation::step(int number)
{
    step_ = number;
    machine_.globals[0] = number;
    auto const stream = static_cast<std::uint32_t>(number);
    machine_.begin_module(stream, kNoPosition);
    machine_.run(model_.start_each);
    if (all_fixed_)
        TRY(rewrite_fixed());
    else
        TRY(rewrite(stream));
    machine_.begin_module(stream, kNoPosition - 1);
    machine_.run(model_.end_each);
    TRY(machine_.check());
    in_.kinds.swap(out_.kinds);
    in_.parameters.swap(out_.parameters);
    return {};
}

Result<void> Derivation::check_size(std::size_t modules, std::size_t parameters) const
{
    // Modules have few parameters; the factor only keeps hostile models in memory.
    auto const limit = std::min(options_.max_modules, kMaxModules);
    if (modules <= limit && parameters / 16 <= limit)
        return {};
    return fail(
        Fault::User,
        fmt::format("{}: step {} makes more than {} modules; derive fewer steps or raise the limit",
                    model_.name, step_, limit));
}

// Every module's successor is known beforehand: counts what comes out, then writes it.
Result<void> Derivation::rewrite_fixed()
{
    std::array<std::size_t, 256> counts {};
    for (auto const kind : in_.kinds.span())
        ++counts[kind];
    std::size_t modules = 0;
    std::size_t parameters = 0;
    for (std::size_t kind = 0; kind < counts.size(); ++kind) {
        modules += counts[kind] * fixed_[kind].length;
        parameters += counts[kind] * fixed_[kind].parameter_count;
    }
    TRY(check_size(modules, parameters));
    out_.kinds.reserve(modules + FixedSuccessor::kShort);
    out_.parameters.reserve(parameters);
    auto* kinds = out_.kinds.data();
    auto* values = out_.parameters.data();
    auto const* from = in_.parameters.data();
    for (auto const kind : in_.kinds.span()) {
        auto const& fixed = fixed_[kind];
        fixed.write(from, kinds, values);
        from += fixed.read_parameter_count;
    }
    out_.kinds.set_size(modules);
    out_.parameters.set_size(parameters);
    return {};
}

// Module after module, from the left.
Result<void> Derivation::rewrite(std::uint32_t step)
{
    out_.kinds.clear();
    out_.parameters.clear();
    out_.kinds.reserve(in_.size());
    out_.parameters.reserve(in_.parameters.size());
    if (rewriter_.has_contexts() || decomposition_.has_contexts())
        find_branches(model_, in_, branches_);
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < in_.size();) {
        auto const& fixed = fixed_[in_.kinds[i]];
        if (fixed.is_fixed) {
            append_fixed(fixed, in_.parameters.data() + parameter);
            parameter += fixed.read_parameter_count;
            ++i;
            continue;
        }
        Modules const rest { in_.kinds.data() + i, in_.parameters.data() + parameter,
                             in_.size() - i };
        machine_.begin_module(step, i);
        auto const count = rewrite_one(rest, { &in_, &branches_, i, parameter, i + 1, 0 });
        for (std::size_t k = 0; k < count; ++k)
            parameter += model_.alphabet[rest.kinds[k]].parameter_count;
        i += count;
        if (out_.size() > options_.max_modules || machine_.loop_did_not_end())
            break;
    }
    return check_size(out_.size(), out_.parameters.size());
}

void Derivation::append_fixed(FixedSuccessor const& fixed, float const* from)
{
    out_.kinds.reserve_more(fixed.length + FixedSuccessor::kShort);
    out_.parameters.reserve_more(fixed.parameter_count);
    auto* kinds = out_.kinds.data() + out_.kinds.size();
    auto* parameters = out_.parameters.data() + out_.parameters.size();
    fixed.write(from, kinds, parameters);
    out_.kinds.set_size(out_.kinds.size() + fixed.length);
    out_.parameters.set_size(out_.parameters.size() + fixed.parameter_count);
}

// Appends what the first module becomes; returns how many modules have been read.
std::size_t Derivation::rewrite_one(Modules const& rest, Surroundings const& around)
{
    auto const kind = rest.kinds[0];
    auto const* const rule
        = rewriter_.has_rules(kind) ? rewriter_.find(rest, around, true) : nullptr;
    if (rule && !model_.decomposition.specified) {
        rewriter_.apply(*rule, out_);
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
                  return out_.size() <= options_.max_modules;
              });
        if (decomposed)
            return std::max<std::size_t>(count, 1);
    }
    if (symbol.symbol == '%' && symbol.parameter_count < 2)
        return branch_end(model_, in_, around.left + 1) - around.left; // A cut.
    append_one(rest);
    return 1;
}

void Derivation::decompose_successor(Surroundings const& around, std::size_t predecessor_length)
{
    auto beyond = around;
    beyond.right = around.left + predecessor_length;
    beyond.right_parameters = around.left_parameters;
    for (auto i = around.left; i < beyond.right; ++i)
        beyond.right_parameters += model_.alphabet[in_.kinds[i]].parameter_count;
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < successor_.size();) {
        Modules const rest { successor_.kinds.data() + i, successor_.parameters.data() + parameter,
                             successor_.size() - i };
        std::size_t count = 1;
        if (decomposition_.has_rules(rest.kinds[0]))
            count = decomposition_.expand(rest, beyond, [&](Modules const& modules) -> std::size_t {
                append_one(modules);
                return out_.size() <= options_.max_modules;
            });
        else
            append_one(rest);
        if (count == 0)
            return; // Too many modules: the caller says so.
        for (std::size_t k = 0; k < count; ++k)
            parameter += model_.alphabet[rest.kinds[k]].parameter_count;
        i += count;
    }
}

void Derivation::append_one(Modules const& modules)
{
    out_.kinds.append(modules.kinds, 1);
    out_.parameters.append(modules.parameters, model_.alphabet[modules.kinds[0]].parameter_count);
}

} // namespace

Result<ModuleString> derive(Model const& model, DeriveOptions const& options)
{
    return Derivation(model, options).run();
}

Result<ModuleString> apply_homomorphism(Model const& model, ModuleString const& string,
                                        std::size_t max_modules)
{
    Machine machine(model, string);
    Expander homomorphism(model, model.homomorphism, machine);
    ModuleString result;
    Branches branches;
    if (homomorphism.has_contexts())
        find_branches(model, string, branches);
    std::size_t parameter = 0;
    for (std::size_t i = 0; i < string.size();) {
        Modules const rest { string.kinds.data() + i, string.parameters.data() + parameter,
                             string.size() - i };
        machine.begin_module(kHomomorphismStep, i);
        Surroundings const around {
            &string,   &branches, i,
            parameter, i + 1,     parameter + model.alphabet[rest.kinds[0]].parameter_count
        };
        auto const count
            = homomorphism.expand(rest, around, [&](Modules const& modules) -> std::size_t {
                  result.kinds.append(modules.kinds, 1);
                  result.parameters.append(modules.parameters,
                                           model.alphabet[modules.kinds[0]].parameter_count);
                  return result.size() <= max_modules;
              });
        TRY(machine.check());
        if (count == 0)
            return fail(Fault::User,
                        fmt::format("{}: the homomorphism makes more than {} modules", model.name,
                                    max_modules));
        for (std::size_t k = 0; k < count; ++k)
            parameter += model.alphabet[rest.kinds[k]].parameter_count;
        i += count;
    }
    result.globals = string.globals;
    result.arrays = string.arrays;
    result.seed = string.seed;
    return result;
}

} // namespace tractus
