// SPDX-License-Identifier: BSD-3-Clause
#include "element/start.hpp"

#include <cmath>
#include <cstring>

#include "element/errors.hpp"
#include "element/text.hpp"

namespace element {
namespace {

double shifted(const grit_sand& sand, double mean_pressure) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_parameters_of(&sand, &p);
    return mean_pressure + p.pressure_shift;
}

// Is it the parameter of this symbol?
bool is(int index, const char* symbol) {
    const grit_sand_parameter_info* const info = grit_sand_parameter_describe(index);
    return info && std::strcmp(info->symbol, symbol) == 0;
}

}  // namespace

IntergranularStrain usual_intergranular_strain(const grit_sand_parameters& parameters) {
    return std::isnan(parameters.elastic_strain_radius) ? IntergranularStrain::off
                                                        : IntergranularStrain::mobilised;
}

VoidRatios void_ratios(const grit_sand& sand, double mean_pressure) {
    double limits[3];  // e_i, e_c, e_d
    grit_sand_void_ratios(&sand, shifted(sand, mean_pressure), limits);
    return {limits[2], limits[1], limits[0]};
}

double void_ratio_at_pressure(const grit_sand& sand, double e_0, double mean_pressure) {
    double e = e_0;
    grit_sand_void_ratio_at_pressure(&sand, e_0, shifted(sand, mean_pressure), &e);
    return e;
}

MaterialPoint start_point(const GritLaw& law, const Start& start) {
    MaterialPoint out = law.start(start.stress, start.void_ratio, start.pore_pressure);
    const double p = -start.stress.head<3>().sum() / 3.0;
    if (!(p > 0.0))
        throw BadCase(text("the initial stress must press: tension is positive, and p = %g", p));
    const VoidRatios limits = void_ratios(law.sand(), p);
    if (!(start.void_ratio >= limits.densest && start.void_ratio <= limits.loosest))
        throw BadCase(
            text("the void ratio must be in [e_d, e_i] = [%.4f, %.4f] at p = %g, got %.6g",
                 limits.densest, limits.loosest, p, start.void_ratio));
    if (start.intergranular_strain == IntergranularStrain::mobilised)
        law.mobilise(out, start.direction, start.rho);
    return out;
}

Slopes start_slopes(const GritLaw& law, const Start& start, const Directions& by,
                    const StartSlopes& given) {
    const auto count = static_cast<Eigen::Index>(by.size());
    if (count < 1) throw BadCase("directions of derivatives: there must be one at least");
    for (const int index : by)
        if (index != by_void_ratio && !grit_sand_parameter_describe(index))
            throw BadCase(text("a direction of derivatives must be in [0, %d), or -1 for the void "
                               "ratio, got %d",
                               static_cast<int>(GRIT_SAND_PARAMETER_COUNT), index));
    for (const Eigen::Index columns : {given.stress.cols(), given.void_ratio.cols()})
        if (columns != 0 && columns != count)
            throw BadCase(text("derivatives of the start must have %d columns, got %d",
                               static_cast<int>(count), static_cast<int>(columns)));
    Slopes out;
    out.by = by;
    out.point.stress = Matrix6X::Zero(6, count);
    out.point.state = MatrixX::Zero(static_cast<Eigen::Index>(law.state_names().size()), count);
    out.strain = Matrix6X::Zero(6, count);
    out.pore_pressure = Eigen::RowVectorXd::Zero(count);
    if (given.stress.cols() > 0) out.point.stress = given.stress;
    const MaterialPoint point = start_point(law, start);
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_parameters_of(&law.sand(), &p);
    for (Eigen::Index k = 0; k < count; ++k) {
        const int index = by[static_cast<std::size_t>(k)];
        auto column = out.point.state.col(k);
        if (given.void_ratio.cols() > 0) column[GRIT_SAND_VOID_RATIO] = given.void_ratio[k];
        else if (index == by_void_ratio) column[GRIT_SAND_VOID_RATIO] = 1.0;
        if (is(index, "R"))
            for (int c = 0; c < 6; ++c)
                column[c] = point.state[static_cast<std::size_t>(c)] / p.elastic_strain_radius;
    }
    return out;
}

// (H6)
Eigen::RowVectorXd slopes_at_pressure(const grit_sand& sand, double e_0, double mean_pressure,
                                      const Directions& by) {
    grit_sand_parameters p;
    grit_sand_parameters_init(&p, sizeof p);
    grit_sand_parameters_of(&sand, &p);
    const double pressure = mean_pressure + p.pressure_shift;
    const double y = 3.0 * pressure / p.granulate_hardness, n = p.stiffness_exponent;
    const double x = std::pow(y, n), e = void_ratio_at_pressure(sand, e_0, mean_pressure);
    Eigen::RowVectorXd out = Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(by.size()));
    for (Eigen::Index k = 0; k < out.cols(); ++k) {
        const int index = by[static_cast<std::size_t>(k)];
        if (index == by_void_ratio) out[k] = e / e_0;
        else if (!(pressure > 0.0)) continue;
        else if (is(index, "h_s")) out[k] = e * n * x / p.granulate_hardness;
        else if (is(index, "n")) out[k] = -e * x * std::log(y);
        else if (is(index, "p_t")) out[k] = -e * n * x / pressure;
    }
    return out;
}

}  // namespace element
