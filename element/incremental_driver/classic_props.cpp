// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/classic_props.hpp"

#include <cmath>

#include "element/errors.hpp"
#include "element/incremental_driver/lines.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

using element::text;

class PropsReader {
  public:
    PropsReader(const Parameters& p, const std::filesystem::path& f) : given(p), path(f) {}

    ClassicSand read() const {
        if (given.props.size() < std::size_t{GRIT_CLASSIC_NPROPS})
            throw BadInput(text("%s: nprops must be at least %d in the classic layout, got %d "
                                "(another layout: --umat)",
                                path.string().c_str(), GRIT_CLASSIC_NPROPS,
                                static_cast<int>(given.props.size())));
        const double phi_c = given.props[0];
        if (!(phi_c >= 10.0 && phi_c <= 60.0))
            fail(0, text("phi_c must be in [10, 60] degrees, got %g%s", phi_c,
                         phi_c > 0.0 && phi_c < 1.1 ? ": radians?" : ""));
        ClassicSand out;
        out.e_0 = given.props[GRIT_CLASSIC_VOID_RATIO_AT_ZERO_PRESSURE];
        grit_sand_parameters parameters;
        grit_classic_parameters(given.props.data(), &parameters);
        element::GritLawOptions options;
        options.intergranular_strain =
            given.props[GRIT_CLASSIC_REVERSAL_STIFFNESS] > GRIT_CLASSIC_NO_MEMORY;
        read_water(options);
        out.has_water = options.has_water();
        if (optional(tolerance) != 0.0) options.tolerance = optional(tolerance);
        try {
            out.law = std::make_shared<element::GritLaw>(parameters, options);
        } catch (const element::BadCase& error) {
            fail(place_of(error.what()), error.what());
        }
        return out;
    }

  private:
    static constexpr int tolerance = GRIT_CLASSIC_TOLERANCE;

    // As for the UMAT.
    double optional(int place) const {
        const auto at = static_cast<std::size_t>(place);
        return at < given.props.size() ? given.props[at] : 0.0;
    }

    void read_water(element::GritLawOptions& options) const {
        const double K_w = given.props[GRIT_CLASSIC_WATER_STIFFNESS];
        grit_sand_water water;
        int bad = 0;
        if (grit_classic_water(K_w, optional(GRIT_CLASSIC_LARGEST_TENSION),
                               optional(GRIT_CLASSIC_WATER_ITSELF), &water, &bad) != GRIT_OK)
            fail(bad, bad == GRIT_CLASSIC_WATER_STIFFNESS ? text("K_w must be >= 0, got %g", K_w)
                      : bad == GRIT_CLASSIC_LARGEST_TENSION
                          ? text("the largest tension must be >= 0, got %g", optional(bad))
                          : text("must be 1, where K_w is that of the water itself, or 0, got %g",
                                 optional(bad)));
        (water.porosity > 0.0 ? options.water_stiffness : options.water_bulk_modulus) = K_w;
        options.largest_tension = water.largest_tension;
    }

    // The library's message begins with the name of a parameter. It has p_t behind beta, PROPS has it
    // behind phi_c.
    static int place_of(const std::string& message) {
        constexpr int pressure_shift = 8;
        for (int i = 0; i < GRIT_SAND_PARAMETER_COUNT; ++i)
            if (message.starts_with(std::string(grit_sand_parameter_describe(i)->name) + " "))
                return i == pressure_shift ? 1 : i == 0 || i > pressure_shift ? i : i + 1;
        return message.starts_with("tolerance ") ? tolerance : 0;
    }

    [[noreturn]] void fail(int place, const std::string& why) const {
        throw BadInput(text("%s:%d: PROPS(%d): %s", path.string().c_str(),
                            given.lines[static_cast<std::size_t>(place)], place + 1, why.c_str()));
    }

    const Parameters& given;
    const std::filesystem::path& path;
};

}  // namespace

ClassicSand read_classic_props(const Parameters& parameters, const std::filesystem::path& path) {
    return PropsReader(parameters, path).read();
}

double void_ratio_at(const ClassicSand& sand, double p) {
    double e = 0.0;
    if (grit_classic_void_ratio(&sand.law->sand(), sand.e_0, p, &e) == GRIT_BAD_STATE)
        throw element::BadCase(text("no void ratio: statev(7) is below 0.001 and PROPS(16) (e_0) "
                                    "is %g",
                                    sand.e_0));
    return e;
}

}  // namespace incremental_driver
