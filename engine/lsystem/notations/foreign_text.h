#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace tractus::lsystem {

// Languages of L-systems other than cpfg's.
enum class Notation : std::uint8_t { LPy, LPlusC, GroImp, Houdini, LParser, Fractint, JsonText };

struct ForeignText {
    Notation notation = Notation::LPy;
    std::string_view name;  // Name of the notation, such as "L-Py (Python)".
    std::uint32_t line = 1; // Number of the line with `sign`, from 1.
    std::string sign;       // The text that identifies the notation, for a message.
};

// Recognises a model in another program's language, by statements that only that language has. No
// value for models in cpfg's language and for all other texts.
std::optional<ForeignText> find_foreign_notation(std::string_view text);

// Returns a sentence that begins with "FILE:LINE:", and says in which language the model is and
// what to do.
std::string describe_foreign_text(std::string_view file, ForeignText const& foreign);

} // namespace tractus::lsystem
