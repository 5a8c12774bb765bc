#include "drivers/logs/line_splitter.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::drivers {

LineSplitter::LineSplitter(std::string name,
                           std::function<Result<void>(std::string_view line)> take)
    : name_(std::move(name))
    , take_(std::move(take))
{
}

Result<void> LineSplitter::feed(std::string_view piece)
{
    for (;;) {
        auto const end = piece.find('\n');
        if (begun_.size() + std::min(end, piece.size()) > kMaxLineBytes)
            return fail(Fault::User,
                        fmt::format("{}:{}: a line of more than {} bytes: this is no log", name_,
                                    lines_ + 1, kMaxLineBytes));
        if (end == std::string_view::npos) {
            begun_.append(piece);
            return {};
        }
        ++lines_;
        if (begun_.empty()) {
            TRY(take_(piece.substr(0, end)));
        } else {
            begun_.append(piece.substr(0, end));
            TRY(take_(begun_));
            begun_.clear();
        }
        piece.remove_prefix(end + 1);
    }
}

Result<void> LineSplitter::end()
{
    if (begun_.empty())
        return {};
    ++lines_;
    return take_(std::exchange(begun_, {}));
}

Result<void> feed_lines(std::istream& in, std::string_view name,
                        std::function<Result<void>(std::string_view line)> take)
{
    LineSplitter lines(std::string(name), std::move(take));
    std::string piece(std::size_t { 1 } << 16, '\0');
    while (in.read(piece.data(), static_cast<std::streamsize>(piece.size())) || in.gcount() > 0)
        TRY(lines.feed(std::string_view(piece).substr(0, static_cast<std::size_t>(in.gcount()))));
    return lines.end();
}

} // namespace tractus::drivers
