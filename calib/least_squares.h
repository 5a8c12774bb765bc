#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>

namespace tractus::calib {

// Least squares as calibration needs them: few parameters, small problems, errors that are honest.

// The product of two matrices of some ten columns. Eigen's own is made for large ones, and takes
// ten seconds to compile wherever it is used.
Eigen::MatrixXd small_product(Eigen::MatrixXd const& a, Eigen::MatrixXd const& b);

// The residuals for some parameters. No value where the model does not hold for them.
using ResidualFunction
    = std::function<std::optional<Eigen::VectorXd>(Eigen::VectorXd const& parameters)>;

struct LeastSquares {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;

    // (J^T J)^-1: times the variance of a residual, the covariance of the parameters.
    Eigen::MatrixXd unit_covariance;

    double sum_of_squares() const { return residuals.squaredNorm(); }
};

// The parameters with the least sum of squared residuals near `start`: Levenberg's and Marquardt's
// method with Marquardt's scaling and differences for derivatives (D. Marquardt, "An algorithm for
// least-squares estimation of nonlinear parameters", SIAM J. Appl. Math. 11, 1963). `steps` says by
// how much each parameter is changed for its derivative; empty: by a millionth of itself. No value
// where the model does not hold at `start`.
std::optional<LeastSquares> fit_least_squares(ResidualFunction const& residuals,
                                              Eigen::VectorXd const& start,
                                              Eigen::VectorXd const& steps = {});

// The covariance of parameters whose residuals depend on their neighbours (a hand trembles slowly
// compared with a tablet's reports), so that many of them say little more than a few: `block` names
// for each residual, in rising order, the stretch of time that it lies in; stretches are taken to
// be independent (the clustered "sandwich" of K.-Y. Liang and S. Zeger, "Longitudinal data analysis
// using generalized linear models", Biometrika 73, 1986, with its correction for few clusters).
Eigen::MatrixXd block_covariance(LeastSquares const& fit, std::span<int const> block);

} // namespace tractus::calib
