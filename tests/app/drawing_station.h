#pragma once

#include "app/document/document.h"
#include "app/station/station.h"

#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace tractus {

// A station together with the document that receives its strokes.
class DrawingStation : public station::Station {
public:
    DrawingStation(station::Station station, scene::Scene scene)
        : station::Station(std::move(station))
        , document_(std::make_unique<document::Document>(std::move(scene),
                                                         document::Document::Working::AtOnce))
    {
    }

    void push(std::size_t device, Timestamp received, std::span<std::byte const> report)
    {
        station::Station::push(device, received, report);
        draw_finished();
    }
    void set_tool(Timestamp time, tools::Tool const& tool)
    {
        station::Station::set_tool(time, tool);
        draw_finished();
    }
    void pass_time(Timestamp now)
    {
        station::Station::pass_time(now);
        draw_finished();
    }
    void finish()
    {
        station::Station::finish();
        draw_finished();
    }

    document::Document& document() { return *document_; }
    document::Document const& document() const { return *document_; }
    scene::Scene const& scene() const { return document_->newest()->scene; }
    std::vector<document::DrawnStroke> const& strokes() const { return strokes_; }

private:
    void draw_finished()
    {
        for (auto& stroke : take_strokes())
            document_->draw(std::move(stroke));
        auto drawn = document_->take_finished_strokes();
        strokes_.insert(strokes_.end(), std::move_iterator(drawn.begin()),
                        std::move_iterator(drawn.end()));
    }

    // Allocated on the heap, so that its address stays the same when the station is moved.
    std::unique_ptr<document::Document> document_;
    std::vector<document::DrawnStroke> strokes_;
};

} // namespace tractus
