#include "engine/lsystem/language/print.h"

#include "engine/base/parallel.h"
#include "engine/lsystem/language/turtle_symbols.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <vector>

namespace tractus::lsystem {

std::size_t symbol_length(Alphabet const& alphabet, std::span<KindId const> kinds)
{
    auto const& first = alphabet[kinds[0]];
    if (first.parameter_count > 0 || kinds.size() < 2)
        return 1;
    auto const& second = alphabet[kinds[1]];
    auto const is_among = [](std::string_view characters, char symbol) {
        return characters.find(symbol) != std::string_view::npos;
    };
    switch (turtle_symbol(first.symbol).does) {
    case SymbolAction::Organ:
        return 2;
    case SymbolAction::Call:
        return is_among(kQueryCharacters, second.symbol) ? 2 : 1;
    case SymbolAction::At:
        break;
    default:
        return 1;
    }
    bool const has_third = second.parameter_count == 0 && kinds.size() > 2
        && is_among(at_symbol(second.symbol).thirds, alphabet[kinds[2]].symbol);
    return has_third ? 3 : 2;
}

std::string to_string(Model const& model, ModuleString const& string)
{
    std::string result;
    result.reserve(string.size() + string.parameters.size() * 8);
    auto const* parameter = string.parameters.data();
    for (auto const id : string.kinds.span()) {
        auto const& kind = model.alphabet[id];
        result.push_back(kind.symbol);
        for (int i = 0; i < kind.parameter_count; ++i) {
            std::array<char, 32> number {};
            auto const length = std::snprintf(number.data(), number.size(), "%g",
                                              static_cast<double>(*parameter++));
            result.push_back(i == 0 ? '(' : ',');
            result.append(number.data(), static_cast<std::size_t>(length));
        }
        if (kind.parameter_count > 0)
            result.push_back(')');
    }
    return result;
}

KindCounts count_kinds(std::span<KindId const> modules)
{
    KindCounts result {};
    // Number of modules to count at a time, so that each count fits into 32 bits.
    constexpr std::size_t kMax = std::size_t { 1 } << 31;
    for (std::size_t begin = 0; begin < modules.size(); begin += kMax) {
        auto const part = modules.subspan(begin, std::min(kMax, modules.size() - begin));
        // Four separate counters, since neighbouring modules are often of the same kind: with one
        // counter, each increment would wait for the one before it.
        std::array<std::array<std::uint32_t, 256>, 4> counts {};
        std::size_t i = 0;
        for (; i + 4 <= part.size(); i += 4)
            for (std::size_t k = 0; k < 4; ++k)
                ++counts[k][part[i + k]];
        for (; i < part.size(); ++i)
            ++counts[0][part[i]];
        for (auto const& sums : counts)
            for (std::size_t kind = 0; kind < sums.size(); ++kind)
                result[kind] += sums[kind];
    }
    return result;
}

// Counts the modules of each kind, in parallel if the string is long enough.
static KindCounts count_kinds_of_all(std::span<KindId const> modules)
{
    constexpr std::size_t kPiece = std::size_t { 1 } << 18;
    std::vector<KindCounts> pieces((modules.size() + kPiece - 1) / kPiece);
    parallel_for(pieces.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i < end; ++i) {
            auto const from = i * kPiece;
            pieces[i] = count_kinds(modules.subspan(from, std::min(kPiece, modules.size() - from)));
        }
    });
    KindCounts result {};
    for (auto const& piece : pieces)
        for (std::size_t kind = 0; kind < result.size(); ++kind)
            result[kind] += piece[kind];
    return result;
}

// Counts symbols that consist of several modules, and subtracts their modules from `single`.
static void count_long_symbols(Alphabet const& alphabet, std::span<KindId const> kinds,
                               KindCounts& single, std::map<std::string, std::size_t>& counts)
{
    std::array<bool, 256> may_begin {};
    bool is_any = false;
    for (std::size_t kind = 0; kind < alphabet.kinds.size(); ++kind) {
        auto const& [symbol, parameter_count] = alphabet.kinds[kind];
        may_begin[kind] = parameter_count == 0 && (symbol == '@' || symbol == '~' || symbol == '?');
        is_any |= may_begin[kind] && single[kind] > 0;
    }
    // The symbol counted last and its count, cached because successive symbols are often equal.
    std::string before;
    std::size_t* count = nullptr;
    for (std::size_t i = 0; is_any && i < kinds.size();) {
        if (!may_begin[kinds[i]]) {
            ++i;
            continue;
        }
        auto const length = symbol_length(alphabet, kinds.subspan(i));
        std::string name;
        for (std::size_t k = 0; length > 1 && k < length; ++k) {
            name.push_back(alphabet[kinds[i + k]].symbol);
            --single[kinds[i + k]];
        }
        if (length > 1 && (!count || name != before)) {
            before = name;
            count = &counts[name];
        }
        if (length > 1)
            ++*count;
        i += length;
    }
}

std::map<std::string, std::size_t> count_symbols(Model const& model, ModuleString const& string)
{
    std::map<std::string, std::size_t> counts;
    auto single = count_kinds_of_all(string.kinds.span());
    count_long_symbols(model.alphabet, string.kinds.span(), single, counts);
    for (std::size_t kind = 0; kind < model.alphabet.kinds.size(); ++kind)
        if (single[kind] > 0)
            counts[std::string(1, model.alphabet.kinds[kind].symbol)] += single[kind];
    return counts;
}

} // namespace tractus::lsystem
