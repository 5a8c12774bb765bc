#include "engine/lsystem/fast_rewriting/context_table.h"

#include <bit>

namespace tractus {

// Tables stay small enough for the processor's first cache, or nearly.
static constexpr unsigned kMaxKindBits = 5;

static bool is_plain(Model const& model, Rule const& rule)
{
    auto const names_a_bracket = [&](std::vector<KindId> const& kinds) {
        return std::any_of(kinds.begin(), kinds.end(), [&](KindId kind) {
            char const symbol = model.alphabet[kind].symbol;
            return symbol == '[' || symbol == ']' || symbol == '=';
        });
    };
    return rule.predecessor.size() == 1 && rule.left.size() <= 1 && rule.right.size() <= 1
        && !rule.has_condition && rule.condition.empty() && rule.successor_program.empty()
        && !names_a_bracket(rule.left) && !names_a_bracket(rule.right)
        && !names_a_bracket(rule.predecessor);
}

std::optional<ContextTable> ContextTable::create(Model const& model)
{
    auto const& kinds = model.alphabet.kinds;
    bool const is_small = static_cast<unsigned>(std::bit_width(kinds.size())) <= kMaxKindBits;
    bool const is_simple = !model.stochastic && !model.ring && !model.decomposition.specified
        && model.subsystems.empty();
    bool const has_plain_kinds
        = std::all_of(kinds.begin(), kinds.end(), [](ModuleKind const& kind) {
              return kind.parameter_count == 0 && kind.symbol != '%';
          });
    auto const& rules = model.rules.rules;
    bool const has_plain_rules = std::all_of(
        rules.begin(), rules.end(), [&](Rule const& rule) { return is_plain(model, rule); });
    bool const has_contexts = std::any_of(rules.begin(), rules.end(), [](Rule const& rule) {
        return !rule.left.empty() || !rule.right.empty();
    });
    // Branches stand out in right contexts unless both brackets are ignored.
    auto const is_ignored = [&](char symbol) {
        auto const kind = find_kind(model.alphabet, { symbol, 0 });
        return kind && model.ignored[*kind];
    };
    if (find_kind(model.alphabet, { '[', 0 }) && find_kind(model.alphabet, { ']', 0 })
        && is_ignored('[') != is_ignored(']'))
        return std::nullopt;
    if (!is_small || !is_simple || !has_plain_kinds || !has_plain_rules || !has_contexts)
        return std::nullopt;
    return ContextTable(model);
}

ContextTable::ContextTable(Model const& model)
    : kind_bits_(static_cast<unsigned>(std::bit_width(model.alphabet.kinds.size())))
    , none_(static_cast<KindId>(model.alphabet.kinds.size()))
{
    auto const count = model.alphabet.kinds.size();
    for (std::size_t i = 0; i < count; ++i) {
        char const symbol = model.alphabet.kinds[i].symbol;
        roles_[i] = symbol == '[' ? Role::Opening
            : symbol == ']'       ? Role::Closing
            : model.ignored[i]    ? Role::Ignored
                                  : Role::Seen;
        sees_branches_ = sees_branches_ && !(symbol == '[' && model.ignored[i]);
        is_row_ = is_row_ && roles_[i] == Role::Seen;
        successors_.push_back(FixedSuccessor::copy(static_cast<KindId>(i), 0));
    }
    for (auto const& rule : model.rules.rules) {
        successors_.push_back(FixedSuccessor::of(rule));
        is_one_to_one_ = is_one_to_one_ && successors_.back().length == 1;
        longest_ = std::max<std::size_t>(longest_, successors_.back().length);
    }

    auto const matches = [&](std::vector<KindId> const& context, std::size_t neighbour) {
        return context.empty() || context.front() == neighbour;
    };
    table_.resize(std::size_t { 1 } << 3 * kind_bits_);
    for (std::size_t left = 0; left <= count; ++left)
        for (std::size_t kind = 0; kind < count; ++kind)
            for (std::size_t right = 0; right <= count; ++right) {
                auto& successor = table_[index(left, kind, right)];
                successor = static_cast<std::uint16_t>(kind);
                for (auto const number : model.rules.by_kind[kind]) {
                    auto const& rule = model.rules.rules[number];
                    if (!matches(rule.left, left) || !matches(rule.right, right))
                        continue;
                    successor = static_cast<std::uint16_t>(count + number);
                    break;
                }
            }
    if (is_one_to_one_)
        for (auto const successor : table_)
            one_to_one_.push_back(successors_[successor].first_kinds[0]);
}

// A branch has nothing to its right; what stands behind it is the right neighbour of what bears it.
void ContextTable::find_right_neighbours(Column<KindId> const& in)
{
    for (auto* const column : { &right_, &stack_ }) // Strings grow: not at every step anew.
        if (column->capacity() < in.size() + 1)
            column->reserve(in.size() + in.size() / 2 + 1);
    auto* const rights = right_.data();
    auto* const stack = stack_.data();
    std::size_t depth = 0;
    auto neighbour = none_;
    for (auto i = in.size(); i-- > 0;) {
        rights[i] = neighbour;
        auto const kind = in[i];
        auto const role = roles_[kind];
        if (!sees_branches_ && (role == Role::Closing || role == Role::Opening))
            continue;
        if (role == Role::Closing) {
            stack[depth++] = neighbour;
            neighbour = none_;
        } else if (role == Role::Opening) {
            neighbour = depth > 0 ? stack[--depth] : none_;
        } else {
            neighbour = role == Role::Seen ? kind : neighbour;
        }
    }
}

template<bool kIsRow, bool kIsOneToOne>
void ContextTable::write(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules)
{
    constexpr std::size_t kBlock = 4096; // Modules between two looks at the memory.
    auto const size = in.size();
    auto const* const kinds = in.data();
    auto const* const rights = right_.data();
    auto* const stack = stack_.data();
    std::size_t depth = 0;
    auto left = none_;
    out.clear();
    out.reserve(std::min(size, max_modules)); // Seldom shorter, and grown without copying.
    for (std::size_t begin = 0; begin < size && out.size() <= max_modules; begin += kBlock) {
        auto const end = std::min(begin + kBlock, size);
        out.reserve_more((end - begin) * longest_ + FixedSuccessor::kShort);
        auto* to = out.data() + out.size();
        for (auto i = begin; i < end; ++i) {
            auto const kind = kinds[i];
            auto const right = !kIsRow ? rights[i] : i + 1 < size ? kinds[i + 1] : none_;
            auto const successor = index(left, kind, right);
            if constexpr (kIsOneToOne)
                *to++ = one_to_one_[successor];
            else
                successors_[table_[successor]].write_kinds(to);
            if constexpr (kIsRow) {
                left = kind;
                continue;
            }
            auto const role = roles_[kind];
            if (role == Role::Opening)
                stack[depth++] = left;
            else if (role == Role::Closing)
                left = depth > 0 ? stack[--depth] : none_;
            else
                left = role == Role::Seen ? kind : left;
        }
        out.set_size(static_cast<std::size_t>(to - out.data()));
    }
}

void ContextTable::rewrite(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules)
{
    if (is_row_)
        return is_one_to_one_ ? write<true, true>(in, out, max_modules)
                              : write<true, false>(in, out, max_modules);
    find_right_neighbours(in);
    return is_one_to_one_ ? write<false, true>(in, out, max_modules)
                          : write<false, false>(in, out, max_modules);
}

} // namespace tractus
