#include "engine/lsystem/print.h"

#include <array>
#include <cctype>
#include <cstdio>
#include <string_view>

namespace tractus {

// The second letters of @-symbols with three characters, by their first: from cpfg's manual.
static bool is_third_character(char second, char third)
{
    static constexpr std::array<std::string_view, 7> kSymbols { "Gscetr", "Tsdpfix", "Did", "bco",
                                                                "Csae",   "PscdSCD", "moc" };
    for (auto const letters : kSymbols)
        if (letters[0] == second)
            return letters.find(third, 1) != std::string_view::npos;
    return false;
}

std::size_t symbol_length(Alphabet const& alphabet, std::span<KindId const> kinds)
{
    auto const& first = alphabet[kinds[0]];
    if (first.parameter_count > 0 || kinds.size() < 2)
        return 1;
    auto const& second = alphabet[kinds[1]];
    if (first.symbol == '~')
        return 2;
    if (first.symbol == '?')
        return std::string_view("PHLUEQR").find(second.symbol) != std::string_view::npos ? 2 : 1;
    if (first.symbol != '@')
        return 1;
    if (second.parameter_count == 0 && kinds.size() > 2
        && is_third_character(second.symbol, alphabet[kinds[2]].symbol))
        return 3;
    return 2;
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

std::map<std::string, std::size_t> count_symbols(Model const& model, ModuleString const& string)
{
    std::array<std::size_t, 256> single {};
    std::map<std::string, std::size_t> counts;
    auto const kinds = string.kinds.span();
    for (std::size_t i = 0; i < kinds.size();) {
        auto const length = symbol_length(model.alphabet, kinds.subspan(i));
        if (length == 1) {
            ++single[kinds[i]];
        } else {
            std::string name;
            for (std::size_t k = 0; k < length; ++k)
                name.push_back(model.alphabet[kinds[i + k]].symbol);
            ++counts[name];
        }
        i += length;
    }
    for (std::size_t kind = 0; kind < model.alphabet.kinds.size(); ++kind)
        if (single[kind] > 0)
            counts[std::string(1, model.alphabet.kinds[kind].symbol)] += single[kind];
    return counts;
}

} // namespace tractus
