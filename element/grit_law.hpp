// SPDX-License-Identifier: BSD-3-Clause
// Grit's own sand, through its public headers.
#pragma once

#include <limits>

#include <grit/grit.h>

#include "element/law.hpp"

namespace element {

// As grit_sand_options_init sets them.
grit_sand_options usual_options();

struct GritLawOptions {
    double tolerance = usual_options().tolerance;  // stress error / |stress|
    int evaluation_limit = usual_options().evaluation_limit;
    bool intergranular_strain = true;  // false: basic hypoplasticity
    // (W1) of one kind of pore water, or none. With it, stress is the total stress and the last state variable the
    // excess pore pressure, below the largest tension as far as a cavity must close.
    double water_stiffness = 0.0;     // K_w/n_p of the mixture [stress], 0: none
    double water_bulk_modulus = 0.0;  // K_w of the water in the pores as they are [stress], 0: none
    double largest_tension = std::numeric_limits<double>::infinity();  // of the water [stress]

    bool has_water() const { return water_stiffness > 0.0 || water_bulk_modulus > 0.0; }
};

// State: h_11 ... h_23 (engineering shear), void_ratio, separation, substep (advice for the next
// call), and pore_pressure if there is water.
class GritLaw : public Law {
  public:
    static constexpr int substep_index = GRIT_SAND_STATE_SIZE;
    static constexpr int pore_pressure_index = GRIT_SAND_STATE_SIZE + 1;

    // Throws BadCase for parameters or options that the library refuses.
    explicit GritLaw(const grit_sand_parameters& parameters, const GritLawOptions& options = {});

    // A point with h = 0. Throws BadCase unless e > 0 and all is finite, or for a pore pressure without water.
    MaterialPoint start(const Vector6& effective_stress, double void_ratio,
                        double pore_pressure = 0.0) const;
    // Set h = rho R along a strain direction (any length > 0), rho in [0, 1]. Throws BadCase.
    void mobilise(MaterialPoint& point, const Vector6& direction, double rho) const;

    Response advance(const MaterialPoint& start, const StrainIncrement& increment) const override;
    Response differentiate(const MaterialPoint& start, const StrainIncrement& increment,
                           const Directions& parameters, const Matrix6X& strain_slopes,
                           PointSlopes& slopes) const override;
    Observation observe(const MaterialPoint& point) const override;
    ObservedSlopes observe(const MaterialPoint& point, const PointSlopes& slopes) const override;
    const std::vector<std::string>& state_names() const override { return names; }

    // p, q, mobilised friction angle and so on, of the effective stress.
    grit_sand_invariants invariants(const MaterialPoint& point) const;
    const grit_sand& sand() const { return prepared; }
    // What bears of a pore pressure [stress].
    double borne(double p_w) const { return grit_sand_water_borne(&water, p_w); }
    bool intergranular_strain() const { return options.intergranular_off == 0; }

  private:
    void read_water(const GritLawOptions& given);
    // What bears.
    double pore_pressure(const MaterialPoint& point) const;
    // d of it by the pore pressure of the state.
    double bearing(const MaterialPoint& point) const;
    double water_pressure_after(const MaterialPoint& start, const MaterialPoint& end,
                                const Vector6& strain_increment) const;
    // Of the state of the end, whose void ratio is differentiated already.
    void differentiate_water(const MaterialPoint& start, const MaterialPoint& end,
                             const Matrix6X& strain_slopes, const Eigen::RowVectorXd& e_before,
                             PointSlopes& slopes) const;

    grit_sand prepared{};
    grit_sand_options options{};
    bool has_water;
    grit_sand_water water{};
    std::vector<std::string> names;
};

}  // namespace element
