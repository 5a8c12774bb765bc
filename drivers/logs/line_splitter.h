#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <functional>
#include <istream>
#include <string>
#include <string_view>

namespace tractus::drivers {

// Cuts a text that comes in pieces into its lines. What grows longer than kMaxLineBytes without a
// line break is no text, and is refused before it fills the memory.
class LineSplitter {
public:
    static constexpr std::size_t kMaxLineBytes = std::size_t { 1 } << 20;

    // `name` is the text's, for messages. `take` gets each line without its line break.
    LineSplitter(std::string name, std::function<Result<void>(std::string_view line)> take);

    // The next piece, cut anywhere. Fails, as the user's fault, at a line that is too long, and as
    // `take` does.
    Result<void> feed(std::string_view piece);

    // The text has ended: a last line without a line break is taken, too. Fails as `take` does.
    Result<void> end();

private:
    std::string name_;
    std::function<Result<void>(std::string_view line)> take_;
    std::string begun_; // Beginning of a line that the last piece did not end.
    std::size_t lines_ = 0;
};

// Cuts all that a stream gives into lines, likewise.
Result<void> feed_lines(std::istream& in, std::string_view name,
                        std::function<Result<void>(std::string_view line)> take);

} // namespace tractus::drivers
