#include "app/options/picture_options.h"

#include <fmt/core.h>

namespace tractus::options {

static std::string check_picture_size(std::string const& text, std::string const& hint)
{
    using render::PictureSize;
    return render::parse_picture_size(text)
        ? std::string()
        : fmt::format("'{}' is no size of a picture: give WIDTHxHEIGHT in pixels, each {} to {}, "
                      "as in 1200x900, or one number for both{}",
                      text, PictureSize::kSmallest_px, PictureSize::kLargest_px, hint);
}

CLI::Option* add_picture_size_option(CLI::App& command, render::PictureSize& size,
                                     std::string const& what, std::string const& hint)
{
    return command
        .add_option_function<std::string>(
            "--size",
            [&size](std::string const& text) { size = *render::parse_picture_size(text); }, what)
        ->type_name("WxH")
        ->check(CLI::Validator(
            [hint](std::string const& text) { return check_picture_size(text, hint); }, ""))
        ->default_str(fmt::format("{}x{}", size.width_px, size.height_px));
}

} // namespace tractus::options
