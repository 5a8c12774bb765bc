#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>

namespace tractus::calib {

// Least squares for calibration: few parameters, small problems, reliable standard errors.

// Multiplies matrices of about ten columns. Eigen's own product is optimised for large matrices,
// and takes ten seconds to compile wherever it is used.
Eigen::MatrixXd small_product(Eigen::MatrixXd const& a, Eigen::MatrixXd const& b);

// Returns the residuals for given parameters; no value where the model is not defined.
using ResidualFunction
    = std::function<std::optional<Eigen::VectorXd>(Eigen::VectorXd const& parameters)>;

struct LeastSquares {
    Eigen::VectorXd parameters;
    Eigen::VectorXd residuals;
    Eigen::MatrixXd jacobian;

    // (J^T J)^-1; multiplied by the variance of a residual it is the covariance of the parameters.
    Eigen::MatrixXd unit_covariance;

    double sum_of_squares() const { return residuals.squaredNorm(); }
};

// Finds the parameters with the least sum of squared residuals near `start`: the
// Levenberg-Marquardt method with Marquardt's scaling and finite differences (D. Marquardt, "An
// algorithm for least-squares estimation of nonlinear parameters", SIAM J. Appl. Math. 11, 1963).
// `steps` is the change of each parameter that estimates its derivative; if empty, a millionth of
// the parameter's value. No value if the model does not hold at `start`.
std::optional<LeastSquares> fit_least_squares(ResidualFunction const& residuals,
                                              Eigen::VectorXd const& start,
                                              Eigen::VectorXd const& steps = {});

// Returns the covariance of parameters whose residuals are correlated in time (a hand trembles
// slowly compared with a tablet's reports), so that many of them have little more information than
// a few. `block` assigns each residual, in rising order, to a stretch of time; stretches are taken
// to be independent (the clustered "sandwich" estimator of K.-Y. Liang and S. Zeger, "Longitudinal
// data analysis using generalized linear models", Biometrika 73, 1986, with its correction for few
// clusters).
Eigen::MatrixXd block_covariance(LeastSquares const& fit, std::span<int const> block);

} // namespace tractus::calib
