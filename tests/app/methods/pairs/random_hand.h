#pragma once

#include "app/document/draw.h"
#include "app/methods/all_methods.h"
#include "app/tools/bent_plant.h"
#include "app/tools/tool_choices.h"
#include "engine/base/random.h"
#include "engine/scene/paper.h"
#include "engine/scene/scene.h"
#include "tests/app/small_model.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace tractus::methods {

// A simulated user who takes random tools with random options and draws at random places, usually
// on plants.
class RandomHand {
public:
    explicit RandomHand(std::uint64_t seed)
        : random_({ .seed = seed })
    {
    }

    bool happens(double share) { return random_.uniform() < share; }

    // Notes that a tool has succeeded. Tools that have never succeeded are tried more often.
    void has_done(tools::Tool const& tool) { ++done_[tool.kind().word]; }
    std::size_t times_done(tools::ToolKind const& kind) { return done_[kind.word]; }

    tools::ToolStroke stroke(scene::Scene const& scene)
    {
        auto tool = any_tool(scene);
        if (tool.needs_no_stroke() && (tool.kind().at_once || happens(0.5)))
            return { {}, tool.done_at_once() };
        return { path(tool, scene), tool };
    }

    scene::SetGrowth growth(scene::SetGrowth growth)
    {
        growth.seed = static_cast<std::uint64_t>(below(5)) + 1;
        growth.age = random_.uniform(0.5, 1);
        return growth;
    }

private:
    std::size_t below(std::size_t count)
    {
        return std::min(static_cast<std::size_t>(random_.uniform() * static_cast<double>(count)),
                        count - 1);
    }

    // Returns a random tool. If there are many plants, the tool often removes one, so that their
    // number stays small.
    tools::Tool any_tool(scene::Scene const& scene)
    {
        constexpr std::size_t kMany = 5;
        auto const tools = all_methods().tools;
        auto const* kind = tools[below(tools.size())];
        for (std::size_t tries = 0; tries < 4 && times_done(*kind) > 0; ++tries)
            kind = tools[below(tools.size())];
        if (scene.plants.size() > kMany && happens(0.3))
            kind = tools::find_tool_kind(tools, "remove_plant");
        tools::Tool tool(*kind);
        auto const words = tools::word_settings(tool);
        for (std::size_t i = 0; i < words.size(); ++i)
            if (happens(0.4))
                tool = tools::with_word(tool, i,
                                        static_cast<int>(below(words[i].option.words.size())));
        auto const numbers = tools::number_settings(tool);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            auto const& [option, value] = numbers[i];
            if (happens(
                    // Numbers are changed only sometimes, and not by much: otherwise nearly all
                    // plants would have the maximum size.
                    0.4))
                tool = tools::with_number(tool, i,
                                          std::clamp(std::round(value * random_.uniform(0.7, 1.2)),
                                                     option.least, option.greatest));
        }
        return tool;
    }

    Vec3 anywhere()
    {
        return { random_.uniform(-90, 90), random_.uniform(-60, 60), random_.uniform(0, 200) };
    }

    Vec3 on_plant(scene::Scene const& scene)
    {
        if (scene.plants.empty())
            return anywhere();
        auto const& plant = *scene.plants[below(scene.plants.size())];
        if (plant.base->segment_count() == 0)
            return anywhere();
        auto const segment = static_cast<SegmentId>(below(plant.base->segment_count()));
        return plant.placement.world_of_plant(tools::BentPlant(plant).end_of(segment));
    }

    Stroke path(tools::Tool const& tool, scene::Scene const& scene)
    {
        if (!drawn_.empty() && happens(0.3))
            return drawn_[drawn_.size() - 1 - below(std::min<std::size_t>(drawn_.size(), 6))];
        auto const place = [&] { return happens(0.7) ? on_plant(scene) : anywhere(); };
        std::vector<Vec3> places { place() };
        for (std::size_t more = 1 + below(4); more > 0; --more)
            places.push_back(happens(0.3) ? place() : Vec3(places.back() + 0.3 * anywhere()));
        if (happens(0.2)) // The path returns to its beginning, as an outline does.
            places.push_back(places.front());
        if (tool.kind().surface != tools::Surface::Space)
            for (auto& at : places) {
                auto const sheet_mm = scene::paper_of(scene.state).sheet_of_world(at);
                at = Vec3(sheet_mm.x(), sheet_mm.y(), 100);
            }
        drawn_.push_back(stroke_through(places));
        return drawn_.back();
    }

    Random random_;
    std::map<std::string, std::size_t> done_;
    std::vector<Stroke> drawn_;
};

} // namespace tractus::methods
