#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace tractus::terminal {

// True if standard output is a terminal whose user can press keys.
bool is_terminal();

// The terminal in full-screen mode. The destructor restores the terminal. At most one object can
// exist at a time.
class Terminal {
public:
    // Fails with a user error if the terminal type ($TERM) is unknown.
    static Result<Terminal> open();

    Terminal(Terminal&&) noexcept;
    Terminal& operator=(Terminal&&) noexcept;
    ~Terminal();

    std::size_t width() const;

    // Shows `lines` from the top of the screen, and `status` in its last line.
    void show(std::vector<std::string> const& lines, std::string const& status);

    // Returns the next pressed key, or no value if none is waiting. Does not block.
    std::optional<char> key();

private:
    struct Screen;
    explicit Terminal(std::unique_ptr<Screen>);

    std::unique_ptr<Screen> screen_;
};

} // namespace tractus::terminal
