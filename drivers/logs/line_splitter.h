#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <functional>
#include <istream>
#include <string>
#include <string_view>

namespace tractus::drivers {

// Splits a text that arrives in pieces into lines. A line longer than kMaxLineBytes cannot be text,
// and is refused before it fills the memory.
class LineSplitter {
public:
    static constexpr std::size_t kMaxLineBytes = std::size_t { 1 } << 20;

    // `name` identifies the text in messages. `take` is called with each line, without its line
    // break.
    LineSplitter(std::string name, std::function<Result<void>(std::string_view line)> take);

    // Adds the next piece, which may end anywhere. Fails with a user error at a line that is
    // too long, and as `take` does.
    Result<void> feed(std::string_view piece);

    // Ends the text: passes on a last line that has no line break. Fails as `take` does.
    Result<void> end();

private:
    std::string name_;
    std::function<Result<void>(std::string_view line)> take_;
    std::string begun_; // Beginning of a line whose end has not arrived yet.
    std::size_t lines_ = 0;
};

// Splits a whole stream into lines, as LineSplitter does.
Result<void> feed_lines(std::istream& in, std::string_view name,
                        std::function<Result<void>(std::string_view line)> take);

} // namespace tractus::drivers
