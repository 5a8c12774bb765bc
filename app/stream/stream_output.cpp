#include "app/stream/stream_output.h"

#include "app/stream/stream_lines.h"

#include <algorithm>
#include <utility>

namespace tractus::stream {

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

Result<void> StreamOutput::take(station::Station& station, scene::Scene const& scene)
{
    auto const moments = station.take_moments();
    TRY(tell(moments, station, scene));
    (void)station.take_strokes();
    return {};
}

Result<void> StreamOutput::tell(std::span<station::PenMoment const> moments,
                                station::Station const& station, scene::Scene const& scene)
{
    if (what_ == What::All)
        for (auto const& moment : moments)
            TRY(put(tip_line(moment), LineServer::Importance::LeaveOut));
    for (auto const& [stroke, tool] : station.new_strokes()) {
        if (stroke.tips.empty())
            continue;
        TRY(tell_steps(stroke, tool, scene));
        TRY(put(stroke_line(++stroke_count_, { stroke, tool }), LineServer::Importance::Keep));
    }
    auto const inks = station.inks();
    std::erase_if(growing_, [&](Growing const& growing) {
        return std::none_of(inks.begin(), inks.end(),
                            [&](auto const& ink) { return ink.front().time == growing.began; });
    });
    for (auto const& ink : inks)
        TRY(tell_steps({ ink }, station.meaning_of(ink), scene));
    return {};
}

// Writes the new growth steps of a stroke. If the stroke has no new tips, it has no new steps.
Result<void> StreamOutput::tell_steps(Stroke const& stroke, tools::Tool const& tool,
                                      scene::Scene const& scene)
{
    auto* const steps = tool.kind().steps;
    if (!steps || what_ != What::All)
        return {};
    auto const began = stroke.tips.front().time;
    auto at = std::find_if(growing_.begin(), growing_.end(),
                           [&](Growing const& growing) { return growing.began == began; });
    if (at == growing_.end())
        at = growing_.insert(growing_.end(), { began });
    if (std::exchange(at->tips, stroke.tips.size()) == stroke.tips.size())
        return {};
    auto const ends_mm = steps(tool, stroke, scene);
    while (at->reported_steps < ends_mm.size()) {
        auto const& end_mm = ends_mm[at->reported_steps++];
        TRY(put(step_line(at->reported_steps, began, stroke.tips.back().time, end_mm),
                LineServer::Importance::Keep));
    }
    return {};
}

void StreamOutput::serve(Timestamp now)
{
    if (server_)
        server_->serve(now);
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

} // namespace tractus::stream
