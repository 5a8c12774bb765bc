#include "app/controllers/leaf_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>

namespace tractus::controllers {

namespace {

constexpr render::Color kPaper { 250, 250, 248, 255 };
constexpr double kLastMonth = 12.99;
constexpr double kSeasonSpread = 0.08; // Spread of the leaves' ages, as on plants in a season.

struct Number {
    char const* text;
    double lsystem::LeafDamage::*number;
    double most;
    double step;
};
constexpr std::array<Number, 5> kNumbers {
    { { "spots {:.0f} %", &lsystem::LeafDamage::spots, 1, 0.01 },
      { "mildew {:.0f} %", &lsystem::LeafDamage::mildew, 1, 0.01 },
      { "mines {:.1f}", &lsystem::LeafDamage::mines, 6, 0.5 },
      { "larvae {:.1f}", &lsystem::LeafDamage::larvae, 8, 0.5 },
      { "withered {:.0f} %", &lsystem::LeafDamage::withered, 1, 0.01 } }
};
// Indices of the page's sliders: the age, the season, and the first of kNumbers.
constexpr std::size_t kAge = 0;
constexpr std::size_t kSeason = 1;
constexpr std::size_t kFirstNumber = 2;

double in_steps(double value, double step)
{
    // Rounds to a multiple of `step`, and then to two decimals for a short text.
    return std::round(std::round(value / step) * step * 100) / 100;
}

view::StartStudy::Picture picture(char const* title, render::Image image)
{
    return { title, std::make_shared<render::Image const>(std::move(image)) };
}

std::string describe_age(double age, std::optional<scene::Season> const& season)
{
    if (!season)
        return fmt::format("age {:.2f}", age);
    return fmt::format("age {:.2f}, by season", age);
}

// Age of a leaf in a season, otherwise its own. Fallen leaves are shown at the greatest age.
double age_of(double own, std::optional<scene::Season> const& season)
{
    return season ? scene::age_in_season(OrganCalendar {}, season->month).value_or(1) : own;
}

} // namespace

LeafPage::LeafPage()
    : job_([](Wanted const& wanted) {
        auto const& grammar = wanted.subject->grammar;
        return methods::study_of_grammar(grammar.text, grammar.name, wanted.look, kPaper);
    })
{
    state_.is_beside_drawing = true;
}

void LeafPage::open(Subject subject)
{
    is_open_ = true;
    is_left_ = false;
    accepted_.reset();
    wanted_ = subject.wanted;
    season_ = subject.season;
    subject_ = std::make_shared<Subject const>(std::move(subject));
    state_.title = subject_->title;
    state_.note.clear();
    state_.study = view::StartStudy { .accept = "Put on the plant" };
    state_.study->details.resize(4);
    state_.study->others.resize(6);
    show_sliders();
    job_.want({ subject_, look() });
}

leaf::LeafLook LeafPage::look() const
{
    return { .age = age_of(wanted_.age, season_),
             .spread = season_ ? kSeasonSpread : 0,
             .damage = wanted_.damage };
}

void LeafPage::slide(std::size_t slider, double value)
{
    if (slider == kAge) {
        season_.reset(); // Otherwise the season would override the chosen age.
        wanted_.age = in_steps(value, 0.01);
    } else if (slider == kSeason) {
        set_season(value);
    } else if (slider - kFirstNumber < kNumbers.size()) {
        auto const& number = kNumbers.at(slider - kFirstNumber);
        wanted_.damage.*number.number = in_steps(value, number.step);
    }
    show_sliders();
    job_.want({ subject_, look() });
}

// Sets the season's month. A month below 1 means that no season is shown.
void LeafPage::set_season(double month)
{
    if (month < 1)
        season_.reset();
    else
        season_ = scene::Season { .month = in_steps(month, 0.01),
                                  .fallen = subject_->season.value_or(scene::Season {}).fallen };
}

void LeafPage::show_sliders()
{
    auto& sliders = state_.study->sliders;
    auto const shown = look();
    sliders = { { describe_age(shown.age, season_), 1, shown.age },
                { season_ ? scene::month_name(season_->month) : std::string("no season"),
                  kLastMonth, season_ ? season_->month : 0 } };
    for (auto const& [text, number, most, step] : kNumbers) {
        double const value = wanted_.damage.*number;
        sliders.push_back(
            { fmt::format(fmt::runtime(text), most > 1 ? value : 100 * value), most, value });
    }
    ++state_.revision;
}

void LeafPage::advance()
{
    auto made = job_.take();
    if (!made || !is_open_)
        return;
    state_.note = *made ? std::string() : made->error().message;
    if (*made)
        show(**std::move(made));
    ++state_.revision;
}

void LeafPage::show(leaf::LeafStudy study)
{
    auto& shown = *state_.study;
    shown.large = picture("", std::move(study.leaf));
    shown.details = { picture("relief", std::move(study.relief)),
                      picture("roughness", std::move(study.roughness)),
                      picture("light through", std::move(study.translucency)),
                      picture("from below", std::move(study.below)) };
    shown.others.clear();
    for (auto& other : study.others)
        shown.others.push_back(picture("", std::move(other)));
}

void LeafPage::settle()
{
    job_.settle();
    advance();
}

void LeafPage::accept()
{
    if (!is_open_)
        return;
    accepted_ = view::SetActiveFoliage { .leaves = wanted_.leaves,
                                         .drawn = wanted_.drawn,
                                         .age = wanted_.age,
                                         .damage = wanted_.damage };
    if (season_ != subject_->season)
        accepted_->season.emplace(season_);
    is_open_ = false;
    ++state_.revision;
}

void LeafPage::leave()
{
    is_open_ = false;
    is_left_ = true;
    ++state_.revision;
}

} // namespace tractus::controllers
