#include "app/svg/svg_transform.h"

#include "app/svg/svg_numbers.h"

#include <cmath>
#include <string>
#include <vector>

namespace tractus::svg {

static Eigen::Affine2d matrix(std::vector<double> const& n)
{
    Eigen::Affine2d result;
    result.matrix() << n[0], n[2], n[4], n[1], n[3], n[5], 0, 0, 1;
    return result;
}

static std::optional<Eigen::Affine2d> transform_of(std::string const& name,
                                                   std::vector<double> const& n)
{
    if (name == "matrix" && n.size() == 6)
        return matrix(n);
    if (name == "translate" && (n.size() == 1 || n.size() == 2))
        return Eigen::Affine2d(Eigen::Translation2d(n[0], n.size() == 2 ? n[1] : 0));
    if (name == "scale" && (n.size() == 1 || n.size() == 2))
        return Eigen::Affine2d(Eigen::Scaling(n[0], n.back()));
    if (name == "rotate" && (n.size() == 1 || n.size() == 3)) {
        Eigen::Translation2d const middle(n.size() == 3 ? Vec2(n[1], n[2]) : Vec2::Zero());
        return middle * Eigen::Rotation2Dd(radians(n[0])) * middle.inverse();
    }
    if (name == "skewX" && n.size() == 1)
        return matrix({ 1, 0, std::tan(radians(n[0])), 1, 0, 0 });
    if (name == "skewY" && n.size() == 1)
        return matrix({ 1, std::tan(radians(n[0])), 0, 1, 0, 0 });
    return std::nullopt;
}

std::optional<Eigen::Affine2d> parse_svg_transform(std::string_view text)
{
    Eigen::Affine2d result = Eigen::Affine2d::Identity();
    SvgNumbers scanner(text);
    while (!scanner.rest().empty()) {
        std::string name;
        auto symbol = scanner.symbol();
        for (; symbol && *symbol != '('; symbol = scanner.symbol())
            name += *symbol;
        std::vector<double> numbers;
        while (auto const number = scanner.number())
            numbers.push_back(*number);
        auto const next = transform_of(name, numbers);
        if (!next || scanner.symbol() != ')')
            return std::nullopt;
        result = result * *next;
    }
    return result;
}

} // namespace tractus::svg
