#include "app/view/station_view.h"

#include "app/render/read_picture.h"
#include "app/tools/tool.h"
#include "app/tools/underground.h"
#include "app/view/drawn_curves.h"
#include "app/view/ink_line.h"
#include "app/view/orphans.h"
#include "engine/variation/growth_preset.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>
#include <unordered_map>
#include <utility>

namespace tractus::view {

StationView::StationView(station::Station const& station, document::Document const& document)
    : proposal_(std::make_unique<NewestJob<ProposalRequest, std::shared_ptr<scene::Scene const>>>(
        [](ProposalRequest const& wanted) -> std::shared_ptr<scene::Scene const> {
            auto scene = scene::apply_edits(*wanted.scene, wanted.edits);
            return scene ? std::make_shared<scene::Scene const>(*std::move(scene)) : nullptr;
        }))
    , reading_(std::make_unique<NewestJob<std::shared_ptr<std::string const>, ReadPicture>>(read))
{
    state_.volume_mm = station.volume_mm();
    nib_ = station.nib();
    layers_.set_layers(station.layers());
    curve_lists_ = station.curves();
    aims_at_ = station.tool().kind().aims_at;
    show_scene(document.newest());
}

void StationView::show(station::Station const& station, document::Document const& document)
{
    finished_strokes_ = station.counts().strokes;
    show_grown();
    take_picture();
    take_proposal();
    show_live(station, document);
    take_first_plant();
    bool const is_drawing = is_drawing_ || !document.waiting().empty();
    // The snapshot is read after the waiting strokes, so that every stroke is among those or in the
    // snapshot.
    auto const snapshot = document.newest();
    state_.unsaved_steps = snapshot->unkept;
    if (snapshot->drawn_revision != shown_drawn_revision_)
        show_scene(snapshot);
    else if (snapshot->revision != shown_revision_)
        grow_plant(snapshot);
    else
        take_saved_snapshot(snapshot);
    if (!is_drawing && std::exchange(is_outcome_proposed_, false))
        propose({}); // The stroke changed nothing, so its preview ends.
    if (!is_drawing && shows_first_plant_)
        show_growth(); // The stroke was refused, so the sheet stays empty.
    show_drawn_gizmo();
}

void StationView::tell(document::DrawnStroke const& drawn)
{
    state_.refused.reset();
    if (!drawn.refusal.empty() && !drawn.stroke.tips.empty())
        state_.refused = RefusedStroke { ink_line(drawn.stroke.tips, drawn.tool, nib_),
                                         drawn.tool.kind().surface, drawn.refusal };
    ++state_.live_revision;
    state_.status = !drawn.refusal.empty() ? drawn.refusal
        : drawn.message.empty()            ? drawn.tool.kind().done
                                           : drawn.message;
}

void StationView::begin_again(station::Station const& station, document::Document const& document)
{
    shown_tips_ = 0;
    finished_strokes_ = station.counts().strokes;
    state_.volume_mm = station.volume_mm();
    if (nib_ != station.nib()) {
        nib_ = station.nib();
        inked_.clear();
    }
    layers_.set_layers(station.layers());
    curve_lists_ = station.curves();
    ++state_.live_revision;
    show_live(station, document);
    show_scene(document.newest());
}

void StationView::show_pen(std::vector<station::PenMoment> const& moments)
{
    state_.pen_path.clear();
    for (auto const& moment : moments)
        state_.pen_path.push_back({ .in_range = moment.in_range,
                                    .touching = moment.touching,
                                    .tip_mm = moment.position_mm.cast<float>(),
                                    .eraser = moment.eraser,
                                    .pressing = moment.pressing,
                                    .barrel = moment.barrel });
    if (!state_.pen_path.empty())
        state_.pen = state_.pen_path.back();
}

// Shows the surface's height. While no pen is near, or while the pen rests, the height follows the
// sensor; changes as small as the sensor's noise are then ignored.
void StationView::show_surface(station::Station const& station)
{
    constexpr double kSeen_mm = 0.5;
    auto const& tip = station.newest_tip();
    bool const follows_pen = station.pen_in_range() && tip.has_value() && !station.pen_rests();
    if (follows_pen)
        state_.surface_height_mm = tip->position_mm.z();
    else if (auto const height_mm = station.surface_height_mm())
        if (std::abs(*height_mm - state_.surface_height_mm) >= kSeen_mm)
            state_.surface_height_mm = *height_mm;
    if (tip) {
        state_.is_outside_calibration = tip->outside_calibration;
        state_.pen.in_range = station.pen_in_range();
        state_.pen.touching = tip->touching;
        state_.pen.tip_mm = tip->position_mm.cast<float>();
        if (station.pen_rests() && !tip->touching) // A resting pen moves with the surface.
            state_.pen.tip_mm.z() = static_cast<float>(state_.surface_height_mm);
    }
    if (std::exchange(shown_surface_mm_, state_.surface_height_mm) != state_.surface_height_mm)
        ++state_.live_revision;
}

// Shows the ink of strokes in progress, and of finished strokes that are not in the scene yet.
void StationView::show_ink(station::Station const& station, Inks inks,
                           std::vector<tools::ToolStroke> const& waiting)
{
    state_.live_ink.clear();
    for (auto const& [stroke, tool] : waiting)
        if (!stroke.tips.empty())
            state_.live_ink.push_back(ink_line(stroke.tips, tool, nib_));
    auto const count = state_.live_ink.size();
    if (std::exchange(shown_waiting_, count) != count)
        ++state_.live_revision;
    if (!inks.empty())
        state_.refused.reset();
    for (auto const& ink : inks)
        state_.live_ink.push_back(ink_line(ink, station.meaning_of(ink), nib_));
}

void StationView::show_live(station::Station const& station, document::Document const& document)
{
    // Without new tips there is nothing to update.
    auto const tips = station.counts().pen_samples + station.counts().tips_in_silence;
    if (std::exchange(shown_tips_, tips) != tips)
        ++state_.live_revision;
    state_.tool = station.tool().title();
    state_.tools = station.tools();
    if (auto const before = std::exchange(state_.hand, station.tool());
        grown_scene_ && !(before == state_.hand)) {
        layers_.show(*grown_scene_, state_.hand); // The selected tool may request other layers.
        update_layers();
    }
    state_.remembered = station.remembered();
    if (std::exchange(aims_at_, state_.hand.kind().aims_at) != state_.hand.kind().aims_at)
        show_skeleton();
    auto const fault = station.height_monitor().present();
    state_.trouble = fault ? calib::describe_fault(*fault) : "";
    auto const inks = station.inks();
    show_ink(station, inks, document.waiting());
    show_selecting(station, inks);
    show_surface(station);
    is_waiting_ = !document.waiting().empty();
    show_preview(station, inks);
}

// Previews the result of the stroke in progress, as often as the background thread can compute it.
// A preview stays until the finished stroke has been applied.
void StationView::show_preview(station::Station const& station, Inks inks)
{
    if (inks.empty() && !is_waiting_)
        set_preview({});
    else if (inks.empty())
        previewed_live_ = state_.live_revision;
    else if (std::exchange(previewed_live_, state_.live_revision) != state_.live_revision)
        previews_->want({ grown_scene_, station.meaning_of(inks.front()), inks.front(),
                          skeleton_.orders(), finished_strokes_ });
    is_drawing_ = !inks.empty();
    take_preview();
    if (is_drawing_)
        propose_outcome(station, inks.front());
}

void StationView::propose_outcome(station::Station const& station,
                                  std::vector<TipSample> const& ink)
{
    auto const tool = station.meaning_of(ink);
    if (!tool.kind().shows_outcome
        || std::exchange(proposed_live_, state_.live_revision) == state_.live_revision)
        return;
    Stroke stroke;
    stroke.tips = ink;
    if (auto edits = tool.edits_for(stroke, *grown_scene_)) {
        is_outcome_proposed_ = true;
        propose(*std::move(edits));
    }
}

void StationView::take_preview()
{
    if (auto made = previews_->take(); made && is_drawing_ && made->stroke == finished_strokes_)
        set_preview(*std::move(made));
    show_paper();
}

void StationView::set_preview(StrokePreview preview)
{
    state_.preview_note = std::move(preview.note);
    state_.preview_paper = preview.paper;
    if (std::exchange(previewed_, preview.lines) == preview.lines)
        return; // Most pen samples do not change the preview.
    ++state_.preview_revision;
    state_.preview = preview.lines ? *preview.lines : std::vector<tools::SkeletonLine>();
    if (std::exchange(framed_stroke_, finished_strokes_) != finished_strokes_)
        preview_frame_ = SteadyFrame(1 / grown_scene_->placement.scale);
    frame_preview();
}

// Grows the first plant of the sheet as far as it has been drawn.
void StationView::take_first_plant()
{
    auto made = previews_->take_first_plant();
    if (!made || !made->scene || !is_drawing_ || made->stroke != finished_strokes_)
        return;
    state_.first_plant_scale = made->scene->placement.scale;
    request_plant({ made->scene, made->scene->growth });
    shows_first_plant_ = true;
}

// Frames the preview if the plant has no skeleton that could be framed.
void StationView::frame_preview()
{
    if (!skeleton_.box_mm().empty())
        return;
    for (auto const& line : state_.preview)
        for (auto const& point_mm : line.points_mm)
            preview_frame_.add(point_mm.cast<double>());
    state_.skeleton_box_mm = preview_frame_.box_mm();
}

// Decides whether the pad shows the plant as it stands on the sheet, for tools that draw in space
// and on paper: while the pen draws, as the stroke is read so far; otherwise, as the plant was
// drawn.
void StationView::show_paper()
{
    auto* const may_draw = state_.hand.kind().may_draw_on_paper;
    if (!may_draw || !may_draw(state_.hand))
        state_.is_paper_upright = false;
    else if (is_drawing_ && previewed_)
        state_.is_paper_upright = state_.preview_paper.has_value();
    else if (auto const* const plant = scene::active_plant(grown_scene_->state);
             !is_drawing_ && !is_waiting_)
        state_.is_paper_upright = plant && plant->paper_mm;
}

// While the pen selects branches, highlights those that its stroke has selected so far or may still
// select.
void StationView::show_selecting(station::Station const& station, Inks inks)
{
    auto const& tool = station.tool();
    auto* const marks = tool.kind().marks_branches;
    bool const marks_branches = marks && marks(tool);
    bool const was_selecting = std::exchange(is_selecting_, marks_branches && !inks.empty());
    if (!is_selecting_) {
        if (was_selecting)
            show_skeleton();
        shown_touched_.reset();
        return;
    }
    if (!shown_skeleton_ || shown_scene_ != grown_scene_ || shown_angle_ != tool.angle()) {
        shown_scene_ = grown_scene_;
        shown_angle_ = tool.angle();
        shown_skeleton_.emplace(*shown_scene_, shown_angle_);
    }
    auto touched = shown_skeleton_->touched_by(inks.front());
    if (shown_touched_ == touched)
        return;
    show_skeleton(touched);
    shown_touched_ = std::move(touched);
}

void StationView::show_scene(std::shared_ptr<document::Snapshot const> const& snapshot)
{
    shown_drawn_revision_ = snapshot->drawn_revision;
    auto const& placement = snapshot->scene.placement;
    state_.T_world_plant = Eigen::Translation3f(placement.origin_mm.cast<float>())
        * Eigen::Scaling(static_cast<float>(placement.scale));
    show_strokes(snapshot->scene);
    show_curves(snapshot->scene);
    show_layers(snapshot->scene);
    state_.paper = scene::paper_of(snapshot->scene.state);
    show_picture(snapshot->scene);
    grow_plant(snapshot);
    show_skeleton();
    shown_touched_.reset();
    list_orphans(snapshot->scene);
}

// Shows the scene's finished strokes. Ink that is already shown is reused, so that its tips need
// not be read again.
void StationView::show_strokes(scene::Scene const& scene)
{
    std::unordered_map<void const*, std::size_t> before;
    for (std::size_t i = 0; i < inked_.size(); ++i)
        before.emplace(inked_[i].id(), i);
    std::vector<SharedVector<TipSample>> inked;
    std::vector<InkLine> lines;
    for (auto const number : scene::shaping_numbers(scene)) {
        auto const& tips = scene.associations[number].what.stroke.tips;
        if (!inked.empty() && inked.back().id() == tips.id())
            // A stroke that shapes several branches is shown once.
            continue;
        auto const found = before.find(tips.id());
        if (found != before.end()) {
            lines.push_back(std::move(state_.strokes[found->second]));
        } else if (auto const read = tips.in_memory()) {
            lines.push_back(thinned(ink_line(*read, {}, nib_)));
        } else {
            // The error is shown. Reading is tried again when the strokes change.
            state_.status = read.error().message;
            continue;
        }
        inked.push_back(tips);
    }
    inked_ = std::move(inked);
    state_.strokes = std::move(lines);
    ++state_.strokes_revision;
}

void StationView::show_curves(scene::Scene const& scene)
{
    state_.curves = drawn_curves(scene, { inked_, state_.strokes }, curve_lists_);
    ++state_.curves_revision;
}

void StationView::show_layers(scene::Scene const& scene)
{
    layers_.show(scene, state_.hand);
    state_.layers = visible_layers();
}

void StationView::pass(Duration step)
{
    layers_.pass(step, state_.hand);
    update_layers();
}

std::vector<ShownLayer> StationView::visible_layers() const
{
    auto layers = layers_.seen();
    if (!grown_underground_mm_.empty())
        layers.push_back({ &tools::kGrownUndergroundLayer, grown_underground_mm_ });
    return layers;
}

void StationView::show_underground(GrownUnderground const& underground)
{
    state_.underground_mm.clear();
    grown_underground_mm_.clear();
    for (auto const& line : underground.lines) {
        state_.underground_mm.push_back({ line.from_mm, line.to_mm });
        if (line.by_growth)
            grown_underground_mm_.push_back(
                { state_.T_world_plant * line.from_mm, state_.T_world_plant * line.to_mm });
    }
    state_.underground = grown_underground_mm_.empty()
        ? ""
        : fmt::format("growth takes {} of {} segments below the ground",
                      grown_underground_mm_.size(), underground.segments);
    update_layers();
}

void StationView::set_along_ground(bool is_on)
{
    state_.along_ground = is_on;
    show_growth();
    if (state_.collection_wanted > 0)
        collect({ state_.collection_wanted, state_.individuality });
}

void StationView::request_plant(PlantRequest wanted)
{
    wanted.along_ground = state_.along_ground;
    grower_->grow(std::move(wanted));
    state_.is_growing = true;
}

// Updates the shown layers if their visibility or their lines have changed.
void StationView::update_layers()
{
    if (state_.layers == visible_layers())
        return;
    state_.layers = visible_layers();
    ++state_.strokes_revision;
    ++state_.skeleton_revision; // The skeleton's view shows layers, too.
}

void StationView::list_orphans(scene::Scene const& scene)
{
    auto const before = state_.orphans.size();
    state_.orphans = orphans_of(scene);
    if (auto const count = state_.orphans.size(); count > before)
        state_.status = fmt::format("The plant has lost {} of the branches that were drawn: what "
                                    "was drawn there waits until they come back",
                                    count);
}

void StationView::show_skeleton(tools::ShownSkeleton::Touched const& touched)
{
    // True if the branches to be shaped next are marked. They are not marked in a proposed scene,
    // which may have another active plant.
    bool const aims = aims_at_ && !is_proposed_;
    auto const next = aims ? aims_at_(*grown_scene_) : std::vector<SegmentId>();
    state_.skeleton = skeleton_.lines(touched, next);
    state_.skeleton_box_mm = skeleton_.box_mm();
    frame_preview();
    ++state_.skeleton_revision;
}

void StationView::grow_plant(std::shared_ptr<document::Snapshot const> const& snapshot)
{
    is_proposed_ = false;
    is_outcome_proposed_ = false;
    shown_revision_ = snapshot->revision;
    grown_scene_ = { snapshot, &snapshot->scene };
    shown_in_place_ = grown_scene_;
    skeleton_.set_scene(grown_scene_);
    preview(grown_scene_->growth);
    auto const& growth = grown_scene_->growth;
    bool const is_same = growth.parameters == collected_growth_.parameters
        && growth.variability == collected_growth_.variability
        && growth.age == collected_growth_.age;
    if (state_.collection_wanted > 0 && !is_same)
        collect({ state_.collection_wanted, state_.individuality });
}

// Takes over a snapshot whose strokes were moved to the file. Nothing visible changes.
void StationView::take_saved_snapshot(std::shared_ptr<document::Snapshot const> const& snapshot)
{
    if (&snapshot->scene == grown_scene_.get())
        return;
    auto const before = std::exchange(grown_scene_, { snapshot, &snapshot->scene });
    for (auto* const shown : { &shown_in_place_, &gizmo_scene_ })
        if (*shown == before)
            *shown = grown_scene_;
}

void StationView::preview(scene::SetGrowth const& growth)
{
    shows_first_plant_ = false;
    state_.seed = growth.seed;
    state_.growth = { std::string(variation::growth_preset_of(growth.parameters)),
                      growth.variability, growth.age };
    request_plant({ grown_scene_, growth });
    state_.season = grown_scene_->state.season;
}

void StationView::preview(std::optional<scene::Season> const& season)
{
    auto seen
        = std::make_shared<scene::Scene const>(scene::preview_in_season(*grown_scene_, season));
    auto const& growth = seen->growth;
    request_plant({ seen, growth });
}

void StationView::propose(std::vector<scene::Edit> edits)
{
    bool const was_proposed = std::exchange(is_proposed_, !edits.empty());
    if (is_proposed_)
        proposal_->want({ grown_scene_, std::move(edits) });
    else if (was_proposed)
        show_in_place(grown_scene_);
}

void StationView::take_proposal()
{
    if (auto const scene = proposal_->take(); scene && *scene && is_proposed_)
        show_in_place(*scene);
}

// Shows the picture, plants and skeleton of a scene, until the next snapshot is shown.
void StationView::show_in_place(std::shared_ptr<scene::Scene const> const& scene)
{
    show_picture(*scene);
    auto const before = std::exchange(shown_in_place_, scene);
    if (before->plants == scene->plants && before->state.active == scene->state.active)
        return;
    skeleton_.set_scene(scene);
    show_skeleton();
    show_layers(*scene);
    ++state_.strokes_revision;
    request_plant({ scene, scene->growth });
}

static bool is_same_file(std::shared_ptr<scene::BackPicture const> const& one,
                         std::shared_ptr<scene::BackPicture const> const& other)
{
    return one && other && (one->file == other->file || *one->file == *other->file);
}

// Shows the picture behind the scene's drawing. A new picture is decoded in the background.
void StationView::show_picture(scene::Scene const& scene)
{
    auto const before = std::exchange(picture_, scene.state.picture);
    if (before == picture_)
        return;
    if (!is_same_file(before, picture_)) {
        state_.picture.reset();
        if (picture_)
            reading_->want(picture_->file);
    }
    if (state_.picture)
        state_.picture->place = picture_->place;
    ++state_.picture_revision;
}

void StationView::show_drawn_gizmo()
{
    auto const* const kind = state_.hand.kind().drawn_gizmo;
    bool const is_same_scene = std::exchange(gizmo_scene_, shown_in_place_) == shown_in_place_;
    if (std::exchange(gizmo_kind_, kind) == kind && is_same_scene)
        return;
    state_.drawn_gizmo = kind ? kind->show(*shown_in_place_) : std::nullopt;
    ++state_.live_revision;
}

void StationView::take_picture()
{
    auto const read = reading_->take();
    if (!read || !picture_ || *read->file != *picture_->file)
        return;
    if (!read->image)
        state_.status = fmt::format("The picture {} is not shown: {}", picture_->name, read->why);
    else
        state_.picture = ShownPicture { read->image, picture_->place };
    ++state_.picture_revision;
}

// Decodes a picture and reduces it to the size of a large screen.
StationView::ReadPicture StationView::read(std::shared_ptr<std::string const> const& file)
{
    constexpr int kLongest_px = 3000;
    auto image = render::read_picture(*file);
    if (!image)
        return { file, nullptr, image.error().message };
    int const longest = std::max(image->width(), image->height());
    if (longest > kLongest_px) {
        auto const side = [&](int length) {
            return std::max(1, static_cast<int>(std::int64_t { length } * kLongest_px / longest));
        };
        image = render::resized(*image, side(image->width()), side(image->height()));
    }
    return { file, std::make_shared<render::Image const>(*std::move(image)) };
}

void StationView::show_growth()
{
    preview(grown_scene_->growth);
}

void StationView::collect(RequestCollection const& wanted)
{
    constexpr std::size_t kMax = 100;
    state_.collection.clear();
    state_.collection_wanted = std::min(wanted.count, kMax);
    state_.individuality = wanted.individuality;
    collected_growth_ = grown_scene_->growth;
    ++state_.collection_revision;
    grower_->vary({ { grown_scene_, grown_scene_->growth, state_.along_ground },
                    state_.collection_wanted,
                    wanted.individuality });
}

void StationView::show_variations()
{
    auto varied = grower_->take_variations();
    if (!varied) {
        state_.status = varied.error().message;
        state_.collection_wanted = state_.collection.size();
        return;
    }
    for (auto& [seed, mesh] : *varied)
        state_.collection.push_back({ seed, std::make_shared<mesh::Mesh const>(std::move(mesh)) });
    state_.collection_revision += !varied->empty();
}

void StationView::settle()
{
    reading_->settle();
    take_picture();
    proposal_->settle();
    take_proposal();
    grower_->settle();
    show_grown();
    previews_->settle();
    take_preview();
    take_first_plant();
    if (shows_first_plant_) {
        grower_->settle();
        show_grown();
    }
    show_drawn_gizmo();
}

void StationView::show_grown()
{
    show_variations();
    auto grown = grower_->take();
    state_.is_growing = grower_->is_growing();
    if (!grown)
        return;
    if (!*grown) {
        state_.status = grown->error().message;
        return;
    }
    if (plant_)
        grower_->drop(std::move(plant_));
    plant_ = std::make_unique<mesh::Mesh const>(**std::move(grown));
    state_.plant = plant_.get();
    state_.is_first_plant_drawn = shows_first_plant_;
    ++state_.plant_revision;
    show_underground(grower_->underground());
}

Result<scene::SetGrowth> with_growth_settings(GrowthView const& wanted, scene::SetGrowth growth)
{
    if (!wanted.preset.empty())
        growth.parameters = TRY(variation::growth_preset(wanted.preset));
    growth.variability = wanted.variability;
    growth.age = wanted.age;
    return growth;
}

} // namespace tractus::view
