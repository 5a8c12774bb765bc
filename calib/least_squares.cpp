#include "calib/least_squares.h"

#include "engine/base/check.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>

namespace tractus::calib {

Eigen::MatrixXd small_product(Eigen::MatrixXd const& a, Eigen::MatrixXd const& b)
{
    return a.lazyProduct(b);
}

namespace {

constexpr int kMaxSteps = 200;
constexpr double kSmallestStep = 1e-10; // Relative change of a parameter at which the search stops.
// Relative change of the sum of squares at which the search stops.
constexpr double kSmallestGain = 1e-12;
constexpr double kGreatestDamping = 1e12;

// Computes the Jacobian by central differences, or one-sided ones at the border of the model.
std::optional<Eigen::MatrixXd> jacobian_at(ResidualFunction const& residuals,
                                           Eigen::VectorXd const& parameters,
                                           Eigen::VectorXd const& here,
                                           Eigen::VectorXd const& steps)
{
    Eigen::MatrixXd jacobian(here.size(), parameters.size());
    for (Eigen::Index i = 0; i < parameters.size(); ++i) {
        double const step
            = steps.size() > 0 ? steps[i] : 1e-6 * std::max(std::abs(parameters[i]), 1e-4);
        Eigen::VectorXd low = parameters;
        Eigen::VectorXd high = parameters;
        low[i] -= step;
        high[i] += step;
        auto const below = residuals(low);
        auto const above = residuals(high);
        if (!below && !above)
            return std::nullopt;
        jacobian.col(i) = ((above ? *above : here) - (below ? *below : here))
            / ((above ? step : 0) + (below ? step : 0));
    }
    return jacobian;
}

// Returns the Moore-Penrose inverse of J^T J, which exists even if a parameter has no effect.
Eigen::MatrixXd inverse_normal(Eigen::MatrixXd const& jacobian)
{
    Eigen::VectorXd const scale = jacobian.colwise().norm().cwiseMax(1e-300);
    Eigen::MatrixXd const scaled = jacobian * scale.cwiseInverse().asDiagonal();
    // J P = Q R gives J^T J = P R^T R P^T, and R is small.
    Eigen::ColPivHouseholderQR<Eigen::MatrixXd> const qr(scaled);
    Eigen::MatrixXd const r = qr.matrixR().topRows(jacobian.cols()).triangularView<Eigen::Upper>();
    Eigen::JacobiSVD<Eigen::MatrixXd, Eigen::NoQRPreconditioner> const svd(r, Eigen::ComputeFullV);
    Eigen::VectorXd inverse = Eigen::VectorXd::Zero(r.cols());
    inverse.head(svd.rank()) = svd.singularValues().head(svd.rank()).cwiseInverse();
    Eigen::MatrixXd const half = scale.cwiseInverse().asDiagonal()
        * Eigen::MatrixXd(qr.colsPermutation() * svd.matrixV()) * inverse.asDiagonal();
    return small_product(half, half.transpose());
}

struct SolverPoint {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
};

// Returns the next point with a smaller sum of squares, increasing the damping after each failure;
// no value if there is none.
std::optional<SolverPoint> better_point(ResidualFunction const& residuals, SolverPoint const& here,
                                        Eigen::MatrixXd const& jacobian, double& damping)
{
    Eigen::MatrixXd const normal = small_product(jacobian.transpose(), jacobian);
    Eigen::VectorXd const gradient = jacobian.transpose() * here.residuals;
    Eigen::VectorXd const scale = normal.diagonal().cwiseMax(1e-300);
    for (; damping < kGreatestDamping; damping *= 10) {
        Eigen::MatrixXd damped = normal;
        damped.diagonal() += damping * scale;
        Eigen::VectorXd const next = here.parameters - damped.ldlt().solve(gradient);
        auto const there = residuals(next);
        if (there && there->squaredNorm() <= here.residuals.squaredNorm())
            return SolverPoint { next, *there };
    }
    return std::nullopt;
}

bool is_small(Eigen::VectorXd const& step, Eigen::VectorXd const& parameters)
{
    return (step.array().abs() <= kSmallestStep * parameters.array().abs().max(1e-6)).all();
}

} // namespace

std::optional<LeastSquares> fit_least_squares(ResidualFunction const& residuals,
                                              Eigen::VectorXd const& start,
                                              Eigen::VectorXd const& steps)
{
    auto const first = residuals(start);
    if (!first)
        return std::nullopt;
    SolverPoint here { start, *first };
    double damping = 1e-3;
    for (int step = 0; step < kMaxSteps; ++step) {
        auto const jacobian = jacobian_at(residuals, here.parameters, here.residuals, steps);
        if (!jacobian)
            return std::nullopt;
        auto next = better_point(residuals, here, *jacobian, damping);
        if (!next)
            break;
        bool const is_there = is_small(next->parameters - here.parameters, here.parameters)
            || next->residuals.squaredNorm() >= (1 - kSmallestGain) * here.residuals.squaredNorm();
        here = *std::move(next);
        damping = std::max(damping / 10, 1e-15);
        if (is_there)
            break;
    }
    auto const jacobian = jacobian_at(residuals, here.parameters, here.residuals, steps);
    if (!jacobian)
        return std::nullopt;
    return LeastSquares { .parameters = here.parameters,
                          .residuals = here.residuals,
                          .jacobian = *jacobian,
                          .unit_covariance = inverse_normal(*jacobian) };
}

Eigen::MatrixXd block_covariance(LeastSquares const& fit, std::span<int const> block)
{
    CHECK(static_cast<Eigen::Index>(block.size()) == fit.residuals.size());
    auto const count = fit.jacobian.cols();
    Eigen::MatrixXd scatter = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd score = Eigen::VectorXd::Zero(count);
    int blocks = 0;
    for (std::size_t i = 0; i < block.size(); ++i) {
        auto const row = static_cast<Eigen::Index>(i);
        score += fit.jacobian.row(row).transpose() * fit.residuals[row];
        if (i + 1 == block.size() || block[i + 1] != block[i]) {
            scatter += score * score.transpose();
            score.setZero();
            ++blocks;
        }
    }
    double const correction = blocks > count ? static_cast<double>(blocks) / double(blocks - count)
                                             : static_cast<double>(blocks);
    return correction
        * small_product(small_product(fit.unit_covariance, scatter), fit.unit_covariance);
}

} // namespace tractus::calib
