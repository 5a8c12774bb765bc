#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::terminal {

// Whether somebody looks at standard output and can press keys.
bool is_terminal();

// The whole screen of the terminal, until it goes: then the terminal is as it was. At most one at a
// time.
class Terminal {
public:
    // Fails, as the user's fault, if the terminal's kind ($TERM) is not known.
    static Result<Terminal> open();

    Terminal(Terminal&&) noexcept;
    Terminal& operator=(Terminal&&) noexcept;
    ~Terminal();

    std::size_t width() const;

    // Shows these lines from the top, and `status` in the last line.
    void show(std::vector<std::string> const& lines, std::string const& status);

    // A key that was pressed; no value if none was. Does not wait.
    std::optional<char> key();

private:
    struct Screen;
    explicit Terminal(std::unique_ptr<Screen>);

    std::unique_ptr<Screen> screen_;
};

} // namespace tractus::terminal
