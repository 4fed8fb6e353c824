// SPDX-License-Identifier: BSD-3-Clause
#include "incremental_driver/classic_props.hpp"

#include <cmath>
#include <iterator>
#include <numbers>

#include <grit/sand_operators.h>

#include "element/errors.hpp"
#include "element/text.hpp"
#include "incremental_driver/lines.hpp"

namespace incremental_driver {
namespace {

using element::text;

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::size_t classic_nprops = 16;
constexpr double offset_of_true_void_ratio = 10.0;
constexpr double intergranular_strain_switch = 0.5;  // m_R at or below: off
constexpr double least_pressure =
    1e-3;  // in any unit of stress: part of the layout, not of the sand

// PROPS(1) ... PROPS(14) by the names of grit_sand_parameters.
constexpr const char* names[] = {"critical_friction_angle", "pressure_shift",
                                 "granulate_hardness",      "stiffness_exponent",
                                 "densest_void_ratio",      "critical_void_ratio",
                                 "loosest_void_ratio",      "pyknotropy_exponent",
                                 "stiffness_void_exponent", "reversal_stiffness",
                                 "transverse_stiffness",    "elastic_strain_radius",
                                 "evolution_exponent",      "stiffness_interpolation_exponent"};
constexpr std::size_t m_R = 9, K_w = 14, e_0 = 15;  // places from 0

void set(grit_sand_parameters& parameters, const std::string& name, double value) {
    for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
        if (name == grit_sand_parameter_describe(i)->name)
            grit_sand_parameter_set(&parameters, i, value);
}

class Reader {
  public:
    Reader(const Parameters& p, const std::filesystem::path& f) : given(p), path(f) {}

    ClassicSand read() const {
        if (given.props.size() < classic_nprops)
            throw BadInput(text("%s: nprops must be at least %d in the classic layout, got %d "
                                "(another layout: --umat)",
                                path.string().c_str(), static_cast<int>(classic_nprops),
                                static_cast<int>(given.props.size())));
        const double phi_c = given.props[0];
        if (!(phi_c >= 10.0 && phi_c <= 60.0))
            fail(0, text("phi_c must be in [10, 60] degrees, got %g%s", phi_c,
                         phi_c > 0.0 && phi_c < 1.1 ? ": radians?" : ""));
        ClassicSand out;
        out.K_w = given.props[K_w];
        out.e_0 = given.props[e_0];
        if (out.K_w < 0.0) fail(K_w, text("K_w must be >= 0, got %g", out.K_w));
        element::GritLawOptions options;
        options.intergranular_strain = given.props[m_R] > intergranular_strain_switch;
        try {
            out.law = std::make_shared<element::GritLaw>(parameters(options.intergranular_strain),
                                                         options);
        } catch (const element::BadCase& error) {
            fail(place_of(error.what()), error.what());
        }
        return out;
    }

  private:
    grit_sand_parameters parameters(bool with_intergranular_strain) const {
        grit_sand_parameters out;
        grit_sand_parameters_init(&out, sizeof out);
        const std::size_t count = with_intergranular_strain ? std::size(names) : m_R;
        for (std::size_t i = 0; i < count; ++i)
            set(out, names[i], given.props[i] * (i == 0 ? degree : 1.0));
        return out;
    }

    // The library's message begins with the name of a parameter.
    static std::size_t place_of(const std::string& message) {
        for (std::size_t i = 0; i < std::size(names); ++i)
            if (message.starts_with(std::string(names[i]) + " ")) return i;
        return 0;
    }

    [[noreturn]] void fail(std::size_t place, const std::string& why) const {
        throw BadInput(text("%s:%d: PROPS(%d): %s", path.string().c_str(), given.lines[place],
                            static_cast<int>(place) + 1, why.c_str()));
    }

    const Parameters& given;
    const std::filesystem::path& path;
};

}  // namespace

ClassicSand read_classic_props(const Parameters& parameters, const std::filesystem::path& path) {
    return Reader(parameters, path).read();
}

double void_ratio_at(const ClassicSand& sand, double p) {
    if (!(sand.e_0 > 0.0))
        throw element::BadCase(text("no void ratio: statev(7) is below 0.001 and PROPS(16) (e_0) "
                                    "is %g",
                                    sand.e_0));
    if (sand.e_0 > offset_of_true_void_ratio) return sand.e_0 - offset_of_true_void_ratio;
    double e = sand.e_0;
    if (p > least_pressure) grit_sand_void_ratio_at_pressure(&sand.law->sand(), sand.e_0, p, &e);
    return e;
}

}  // namespace incremental_driver
