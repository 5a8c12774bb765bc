#include "app/stream/stream_output.h"

#include "app/stream/stream_lines.h"

#include <utility>

namespace tractus {

Result<StreamOutput> StreamOutput::open(Write write, Bounds const& volume_mm, What what)
{
    TRY(write(stream_line(volume_mm)));
    return StreamOutput(std::move(write), std::nullopt, what);
}

Result<StreamOutput> StreamOutput::open_socket(std::filesystem::path const& path,
                                               Bounds const& volume_mm, What what)
{
    return StreamOutput(nullptr, TRY(LineServer::listen(path, stream_line(volume_mm))), what);
}

StreamOutput::StreamOutput(Write write, std::optional<LineServer> server, What what)
    : write_(std::move(write))
    , server_(std::move(server))
    , what_(what)
{
}

Result<void> StreamOutput::take(Station& station)
{
    for (auto const& moment : station.take_moments())
        if (what_ == What::All)
            TRY(put(tip_line(moment), LineServer::Importance::LeaveOut));
    for (auto const& stroke : station.take_strokes())
        if (!stroke.stroke.tips.empty())
            TRY(put(stroke_line(++stroke_count_, stroke), LineServer::Importance::Keep));
    return {};
}

void StreamOutput::serve()
{
    if (server_)
        server_->serve();
}

Result<void> StreamOutput::end()
{
    return put(end_line(), LineServer::Importance::Keep);
}

Result<void> StreamOutput::put(std::string const& line, LineServer::Importance importance)
{
    if (!server_)
        return write_(line);
    server_->publish(line, importance);
    return {};
}

} // namespace tractus
