#include "engine/lsystem/fast_rewriting/context_table.h"

#include "engine/base/parallel.h"

#include <algorithm>
#include <bit>

namespace tractus::lsystem {

// Maximum number of bits of a kind. It limits the table to 64 kB, about the size of a processor's
// level 1 cache.
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
    // Right contexts see brackets as the limits of branches unless both brackets are ignored.
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
{
    roles_.none = static_cast<KindId>(model.alphabet.kinds.size());
    auto const count = model.alphabet.kinds.size();
    for (std::size_t i = 0; i < count; ++i) {
        char const symbol = model.alphabet.kinds[i].symbol;
        roles_.of_kind[i] = symbol == '[' ? Role::Opening
            : symbol == ']'               ? Role::Closing
            : model.ignored[i]            ? Role::Ignored
                                          : Role::Seen;
        roles_.sees_branches = roles_.sees_branches && !(symbol == '[' && model.ignored[i]);
        is_row_ = is_row_ && roles_.of_kind[i] == Role::Seen;
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
                auto& successor = table_[index(kind_bits_, left, kind, right)];
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

void ContextTable::find_right_neighbours(Task const& task)
{
    auto const size = task.in.size();
    // Reserves more than needed, so that a growing string does not reallocate at every step.
    if (right_.capacity() < size + 1)
        right_.reserve(size + size / 2 + 1);
    pieces_.resize(task.piece_count);
    parallel_for(task.piece_count, 1, [&](std::size_t first, std::size_t last) {
        for (auto i = first; i < last; ++i)
            pieces_[i].read(roles_, task.in.data(), i * task.piece,
                            std::min((i + 1) * task.piece, size), right_.data());
    });
    join_neighbours(roles_, pieces_);
    parallel_for(task.piece_count, 1, [&](std::size_t first, std::size_t last) {
        for (auto i = first; i < last; ++i)
            pieces_[i].write_missing(right_.data());
    });
}

// Appends the successors of a piece's modules. Members are copied to local variables: kinds are
// bytes, so the compiler must assume that writing them changes any other object in memory.
template<bool kIsRow, bool kIsOneToOne>
void ContextTable::write(Task const& task, std::size_t number, Column<KindId>& waiting,
                         Column<KindId>& out) const
{
    constexpr std::size_t kBlock = 4096; // Number of modules for which room is reserved at a time.
    auto const size = task.in.size();
    auto const first = number * task.piece;
    auto const last = std::min(first + task.piece, size);
    auto const* const kinds = task.in.data();
    auto const* const rights = right_.data();
    auto const roles = roles_;
    auto const bits = kind_bits_;
    auto const* const table = table_.data();
    auto const* const successors = successors_.data();
    auto const* const one_to_one = one_to_one_.data();
    auto left = first > 0 ? kinds[first - 1] : roles.none;
    KindId* stack = nullptr;
    std::size_t depth = 0;
    if constexpr (!kIsRow) {
        auto const& neighbours = pieces_[number];
        left = neighbours.left();
        depth = neighbours.waiting_lefts().size();
        if (waiting.capacity() < depth + task.piece)
            waiting.reserve(depth + task.piece);
        stack = waiting.data();
        std::copy_n(neighbours.waiting_lefts().data(), depth, stack);
    }
    for (auto begin = first; begin < last && out.size() <= task.max_modules; begin += kBlock) {
        auto const end = std::min(begin + kBlock, last);
        out.reserve_more((end - begin) * longest_ + FixedSuccessor::kShort);
        auto* to = out.data() + out.size();
        for (auto i = begin; i < end; ++i) {
            auto const kind = kinds[i];
            auto const right = !kIsRow ? rights[i] : i + 1 < size ? kinds[i + 1] : roles.none;
            auto const at = index(bits, left, kind, right);
            if constexpr (kIsOneToOne)
                *to++ = one_to_one[at];
            else
                successors[table[at]].write_kinds(to);
            if constexpr (kIsRow) {
                left = kind;
                continue;
            }
            auto const role = roles.of_kind[kind];
            if (role == Role::Opening)
                stack[depth++] = left;
            else if (role == Role::Closing)
                left = depth > 0 ? stack[--depth] : roles.none;
            else
                left = role == Role::Seen ? kind : left;
        }
        out.set_size(static_cast<std::size_t>(to - out.data()));
    }
}

void ContextTable::write_piece(Task const& task, std::size_t number, Column<KindId>& stack,
                               Column<KindId>& out) const
{
    if (is_row_)
        return is_one_to_one_ ? write<true, true>(task, number, stack, out)
                              : write<true, false>(task, number, stack, out);
    return is_one_to_one_ ? write<false, true>(task, number, stack, out)
                          : write<false, false>(task, number, stack, out);
}

// Rewrites kPiecesAtATime pieces in parallel, each into its own buffer, appends the results to
// `out`, and continues with the next pieces.
void ContextTable::write_in_parallel(Task const& task, Column<KindId>& out)
{
    constexpr std::size_t kPiecesAtATime = 32;
    written_.resize(std::min(task.piece_count, kPiecesAtATime));
    for (std::size_t first = 0; first < task.piece_count && out.size() <= task.max_modules;
         first += written_.size()) {
        auto const count = std::min(written_.size(), task.piece_count - first);
        parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i < end; ++i) {
                written_[i].out.clear();
                write_piece(task, first + i, written_[i].stack, written_[i].out);
            }
        });
        std::vector<std::size_t> places { out.size() };
        for (std::size_t i = 0; i < count; ++i)
            places.push_back(places.back() + written_[i].out.size());
        out.reserve_more(places.back() - out.size());
        out.set_size(places.back());
        if (out.size() <= task.max_modules)
            parallel_for(count, 1, [&](std::size_t begin, std::size_t end) {
                for (auto i = begin; i < end; ++i)
                    std::copy_n(written_[i].out.data(), written_[i].out.size(),
                                out.data() + places[i]);
            });
    }
}

void ContextTable::rewrite(Column<KindId> const& in, Column<KindId>& out, std::size_t max_modules,
                           std::size_t piece)
{
    Task const task { in, max_modules, piece, (in.size() + piece - 1) / piece };
    if (!is_row_)
        find_right_neighbours(task);
    out.clear();
    // The result is seldom shorter than the input. If it is longer, growing does not copy it.
    out.reserve(std::min(in.size(), max_modules));
    if (task.piece_count > 2 && thread_count() > 1)
        return write_in_parallel(task, out);
    written_.resize(1);
    for (std::size_t i = 0; i < task.piece_count && out.size() <= max_modules; ++i)
        write_piece(task, i, written_.front().stack, out);
}

} // namespace tractus::lsystem
