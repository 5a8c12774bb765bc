#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <array>
#include <cstddef>
#include <map>
#include <span>
#include <string>

namespace tractus::lsystem {

// How many modules the turtle's symbol that begins with kinds[0] has: 2 for ~S and ?P, 2 or 3 for
// @-symbols such as @o and @Ts, else 1.
std::size_t symbol_length(Alphabet const& alphabet, std::span<KindId const> kinds);

// The string as cpfg writes it, without line breaks: parameters as C's %g.
std::string to_string(Model const& model, ModuleString const& string);

// How often each kind is among modules: by kind, 0 for those that there are not.
using KindCounts = std::array<std::size_t, 256>;
KindCounts count_kinds(std::span<KindId const> modules);

// How often each symbol stands in the string, whatever its parameters. @-symbols, ~S and ?P count
// as one.
std::map<std::string, std::size_t> count_symbols(Model const& model, ModuleString const& string);

} // namespace tractus::lsystem
