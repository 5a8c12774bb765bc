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

// The terminal in full-screen mode; the destructor restores it. At most one can exist at a time.
class Terminal {
public:
    // Fails with a user error if the terminal type ($TERM) is unknown.
    static Result<Terminal> open();

    Terminal(Terminal&&) noexcept;
    Terminal& operator=(Terminal&&) noexcept;
    ~Terminal();

    std::size_t width() const;

    // Shows these lines from the top, and `status` in the last line.
    void show(std::vector<std::string> const& lines, std::string const& status);

    // The next pressed key, or no value if there is none. Does not wait.
    std::optional<char> key();

private:
    struct Screen;
    explicit Terminal(std::unique_ptr<Screen>);

    std::unique_ptr<Screen> screen_;
};

} // namespace tractus::terminal
