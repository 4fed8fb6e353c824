// SPDX-License-Identifier: BSD-3-Clause
#include "robustness/mpm_case.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace robustness {
namespace {

using Random = grit::SplitMix;

template <class Choice> Choice one_of(Random& random, std::initializer_list<Choice> choices) {
    return choices.begin()[random.below(static_cast<int>(choices.size()))];
}

bool one_in(Random& random, int n) { return random.below(n) == 0; }

struct Range {
    double from, to;
    double mean() const { return 0.5 * (from + to); }
};

std::string of(Range range) { return fmt::format("[{:.17g}, {:.17g}]", range.from, range.to); }

// A body as it was drawn.
struct Drawn {
    std::string name;
    Range across, up;
    bool rigid = false, free = false, sand = false, water = false, round = false;
    double modulus = 1e4;  // of P-waves, about [kPa]
};

class Writer {
  public:
    explicit Writer(Random& numbers) : random(numbers) {}

    MpmCase write() {
        geometry = one_of(random, {plane, axisymmetric, space});
        out.in_space = geometry == space;
        out.floating = one_in(random, 4);
        cell = random.log_uniform(0.01, 10.0);
        cells = {4 + random.below(out.in_space ? 2 : 5), 6 + random.below(out.in_space ? 3 : 7)};
        from = geometry == axisymmetric && !one_in(random, 4) ? 0.0 : cell * random.below(4);
        line("gravity_m_per_s2 = {:.17g}", one_in(random, 4) ? 0.0 : random.log_uniform(0.1, 100));
        grid();
        boundary();
        numerics();
        stack();
        for (std::size_t i = 1; i < bodies.size(); ++i) contact(bodies[i - 1], bodies[i]);
        if (bodies.size() > 2 && one_in(random, 4)) contact(bodies.front(), bodies.back());
        if (!out.floating && one_in(random, 3)) traction();
        if (one_in(random, 3)) {  // ends with its first step
            line("[[stage]]\nname = \"first\"");
            if (!out.floating) maybe(2, "local_damping = {:.17g}", random.uniform(0.0, 0.8));
            if (!out.floating) maybe(3, "gravity = false");
            line("[stage.until]\ntime_s = 1e-12");
        }
        line("[[stage]]\nname = \"all\"\n[stage.until]\ntime_s = 1e9\n[history]\ninterval_s = 0");
        return std::move(out);
    }

  private:
    enum Geometry { plane, axisymmetric, space };

    template <class... Values> void line(std::string_view format, const Values&... values) {
        fmt::format_to(std::back_inserter(out.text), fmt::runtime(format), values...);
        out.text += '\n';
    }
    // Most of the time not: the default.
    template <class... Values> void maybe(int n, std::string_view format, const Values&... values) {
        if (one_in(random, n)) line(format, values...);
    }
    double high() const { return cell * cells[1]; }
    Range whole() const { return {from, from + cell * cells[0]}; }

    void axis(const char* name, double end, int count) {
        line("[[grid.{}]]\nto_m = {:.17g}\ncells = {}", name, end, count);
        maybe(6, "growth = {:.17g}", random.uniform(0.9, 1.1));
    }

    void grid() {
        static const char* const names[] = {"plane_strain", "axisymmetric", "space"};
        line("[grid]\ngeometry = \"{}\"", names[geometry]);
        line("{}_from_m = {:.17g}", out.in_space ? "x" : "r", from);
        if (out.in_space) line("y_from_m = {:.17g}", from);
        const Range across = whole();
        axis(out.in_space ? "x" : "r", across.to, cells[0]);
        if (out.in_space) axis("y", across.to, cells[0]);
        axis("z", high(), cells[1]);
    }

    void boundary() {
        line("[boundary]");
        const bool axis_inside = geometry == axisymmetric && from == 0.0;
        const auto side = [&](const char* name) {
            const char* kind = one_of(random, {"roller", "roller", "fixed", "free"});
            if (one_in(random, out.in_space ? 200 : 16)) kind = "absorbing", absorbs = true;
            if (one_in(random, out.in_space ? 200 : 30)) kind = "platen";
            line("{} = \"{}\"", name, kind);
        };
        if (axis_inside) line("left = \"roller\"");
        if (out.floating) return;
        if (!axis_inside) side("left");
        side("right");
        if (out.in_space) side("front"), side("back");
        side("bottom");
        if (one_in(random, 2)) side("top");
        if (absorbs)
            line("p_wave_m_per_s = {:.17g}\ns_wave_m_per_s = {:.17g}",
                 random.log_uniform(250, 2000), random.log_uniform(5, 300));
        if (!out.in_space) maybe(6, "drained = [\"{}\"]", one_of(random, {"right", "top"}));
    }

    void numerics() {
        line("[numerics]");
        if (out.in_space) {
            maybe(20, "shape_function = \"ugimp\"");
        } else {
            line("shape_function = \"{}\"",
                 one_of(random, {"cpdi", "cpdi", "cpdi_published", "ugimp", "linear"}));
            if (one_in(random, 3))
                usl = false, line("scheme = \"{}\"", one_of(random, {"musl", "usf"}));
            maybe(4, "fixed_point = true");
            maybe(4, "reduced_domains = true");
        }
        line("cfl = {:.17g}", random.uniform(0.05, 0.5));
        maybe(2, "pic_rate_per_s = {:.17g}", random.log_uniform(0.1, 1000.0));
        if (!out.floating) maybe(3, "local_damping = {:.17g}", random.uniform(0.0, 0.8));
        maybe(2, "bulk_viscosity_linear = {:.17g}", random.uniform(0.0, 0.3));
        maybe(3, "bulk_viscosity_quadratic = {:.17g}", random.uniform(0.0, 2.0));
        maybe(3, "cell_averaged_volume = true");
    }

    // Upwards, with gaps or without; floating ones away from all sides.
    void stack() {
        const int number = 2 + random.below(3);
        const double margin = out.floating ? 1.5 * cell : 0.0;
        double level = margin + (one_in(random, 2) ? 0.0 : cell * random.uniform());
        const double room = (high() - margin - level) / number;
        for (int i = 0; i < number; ++i) {
            Drawn body;
            body.name = fmt::format("body{}", i);
            const double gap = one_in(random, 2) ? 0.0 : 0.4 * room * random.uniform();
            body.up = {level, level + room - gap};
            level += room;
            body.across = across();
            draw(body);
            bodies.push_back(body);
        }
    }

    Range across() {
        const Range all = whole();
        if (out.floating)
            return {from == 0.0 && geometry == axisymmetric ? 0.0 : all.from + 1.5 * cell,
                    all.to - 1.5 * cell};
        if (one_in(random, 2)) return all;
        const double width = all.to - all.from;
        const double begin = one_in(random, 2) ? 0.0 : random.uniform(0.0, 0.4) * width;
        return {all.from + begin, all.from + begin + random.uniform(0.3, 0.6) * width};
    }

    void draw(Drawn& body) {
        line("[[body]]\nname = \"{}\"", body.name);
        const int kind = out.floating ? random.below(3) : random.below(5);
        body.rigid = kind == 4;
        body.sand = kind == 2 || kind == 3;
        body.water = !body.rigid && !out.in_space &&
                     one_in(random, !usl           ? 30
                                    : out.floating ? 8
                                                   : 3);
        const double density = random.log_uniform(500, 5000);
        const double E = random.log_uniform(10, 1e6);  // kPa
        const double c = body.sand ? 100.0 : std::sqrt(1e3 * E / density);
        if (!body.rigid) {
            if (body.water) line("grain_density_kg_per_m3 = {:.17g}", density);
            else line("density_kg_per_m3 = {:.17g}", density);
            const double v = c * random.log_uniform(1e-6, one_in(random, 10) ? 0.5 : 0.03);
            out.fastest = std::max(out.fastest, v);
            out.slowest_wave = std::min(out.slowest_wave, c);
            const double along = one_in(random, 2) ? v : -v, up = one_in(random, 2) ? 0.3 * v : -v;
            if (out.in_space)
                line("velocity_m_per_s = [{:.17g}, {:.17g}, {:.17g}]", along, 0.5 * v, up);
            else line("velocity_m_per_s = [{:.17g}, {:.17g}]", geometry == plane ? along : 0.0, up);
        }
        if (!out.in_space)
            line("particles_per_cell_r = {}\nparticles_per_cell_z = {}", 1 + random.below(3),
                 1 + random.below(3));
        shape(body);
        if (body.rigid && out.in_space && one_in(random, 2)) {
            body.free = true;
            std::string degrees;
            for (const char* degree : {"x", "y", "z", "about_x", "about_y", "about_z"})
                if (degrees.empty() || one_in(random, 2))
                    degrees += fmt::format("{}\"{}\"", degrees.empty() ? "" : ", ", degree);
            line("[body.rigid]\nfree = [{}]", degrees);
            return;
        }
        if (body.rigid) {
            line("[body.rigid]\nvelocity_z_m_per_s = [{:.17g}]",
                 random.uniform(-1.0, 1.0) * random.log_uniform(1e-3, 1.0));
            return;
        }
        if (body.sand) {
            sand(body);
        } else {
            const double nu = random.uniform(0.0, 0.45);
            line("[body.{}]\nyoungs_modulus_kPa = {:.17g}\npoissons_ratio = {:.17g}",
                 kind == 0 ? "elastic" : "neo_hooke", E, nu);
            body.modulus = E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
        }
        if (body.water) water(body);
    }

    void shape(Drawn& body) {
        if (!out.in_space) {
            line("[[body.box]]\nr_m = {}\nz_m = {}", of(body.across), of(body.up));
            return;
        }
        const double half = 0.5 * (body.across.to - body.across.from), middle = body.across.mean();
        const int kind = random.below(5);
        body.round = kind < 2;
        switch (kind) {
            case 0:
                line("[[body.cylinder]]\ncentre_m = [{0:.17g}, {0:.17g}]\nradius_m = {1:.17g}\nz_m "
                     "= {2}",
                     middle, half, of(body.up));
                break;
            case 1:
                line("[[body.sphere]]\ncentre_m = [{0:.17g}, {0:.17g}, {1:.17g}]\nradius_m = "
                     "{2:.17g}",
                     middle, body.up.mean(), std::min(half, 0.5 * (body.up.to - body.up.from)));
                break;
            default:
                line("[[body.box]]\nx_m = {0}\ny_m = {0}\nz_m = {1}", of(body.across), of(body.up));
        }
    }

    void sand(const Drawn& body) {
        line("[body.sand]\nname = \"{}\"\nvoid_ratio = {:.17g}",
             one_of(random, {"lausitz", "karlsruhe-fine", "hochstetten"}),
             random.uniform(0.68, 0.85));
        maybe(4, "intergranular_strain = \"{}\"", one_of(random, {"zero", "off"}));
        maybe(4, "tolerance = {:.17g}", random.log_uniform(1e-6, 1e-2));
        line("[body.stress_at_rest]\nsurface_m = {:.17g}\nsurcharge_kPa = {:.17g}", body.up.to,
             random.log_uniform(0.1, 200));
        maybe(2, "K0 = {:.17g}", random.uniform(0.4, 1.2));
    }

    void water(const Drawn& body) {
        const bool flows = !out.floating && one_in(random, 2);  // it has momentum of its own
        line("[body.water]\ndrainage = \"{}\"", flows ? "flow" : "undrained");
        maybe(3, "pressure = \"implicit\"");
        line("bulk_modulus_kPa = {:.17g}", random.log_uniform(1e3, 2.2e6));
        if (flows) line("conductivity_m_per_s = {:.17g}", random.log_uniform(1e-6, 1e-1));
        if (flows) maybe(2, "conductivity_law = \"kozeny_carman\"");
        if (!body.sand) line("porosity = {:.17g}", random.uniform(0.2, 0.6));
        maybe(3, "water_table_m = {:.17g}", body.up.to);
    }

    void contact(const Drawn& stiff, const Drawn& soft) {
        line("[[contact]]\nstiff = \"{}\"\nsoft = \"{}\"", stiff.name, soft.name);
        maybe(2, "friction_coefficient = {:.17g}", random.uniform(0.0, 1.5));
        const bool at_nodes = stiff.free || soft.free;
        switch (random.below(at_nodes ? 2 : out.in_space ? 4 : 5)) {
            case 0: geo(soft); return;
            case 1:
                line("law = \"frictional\"");
                maybe(3, "gated = {}", one_of(random, {"true", "false"}));
                break;
            case 2:
            case 3:
                line("law = \"surface\"");
                maybe(4, "pressure_spacing_cells = {:.17g}", random.log_uniform(1.0, 4.0));
                maybe(4, "sweep_tolerance = {:.17g}", random.log_uniform(1e-14, 1.0));
                // Bricks of what is round reach into what it touches: a stiffness would hold that from the start.
                if (one_in(random, 4) && !stiff.round && !soft.round) {
                    line("contact_stiffness_multiple = {:.17g}\nmodulus_kPa = {:.17g}",
                         random.log_uniform(0.01, 100.0), soft.modulus);
                    maybe(2, "relaxation_time_s = {:.17g}", random.log_uniform(1e-6, 1e-2));
                } else if (!out.in_space) {
                    maybe(4, "after_damping = true");
                }
                if (!out.in_space) maybe(4, "stiff_line = {}", top_of(stiff));
                return;
            default: penalty(stiff, soft); return;
        }
        if (!out.in_space)
            maybe(2, "normal = \"{}\"", one_of(random, {"stiff", "soft", "average"}));
    }

    void geo(const Drawn& soft) {
        line("law = \"geo\"");
        maybe(2, "penalty_power = {:.17g}", random.log_uniform(0.1, 100.0));
        maybe(2, "normal = \"{}\"", one_of(random, {"stiff", "soft", "average"}));
        maybe(3, "distance = \"{}\"", one_of(random, {"support", "edge", "nearest_centre"}));
        maybe(3, "relaxation_time_s = {:.17g}", random.log_uniform(1e-7, 1e-2));
        if (one_in(random, 3)) {
            line("contact_stiffness_multiple = {:.17g}\nmodulus_kPa = {:.17g}",
                 random.log_uniform(0.01, 10.0), soft.modulus);
            return;
        }
        maybe(4, "gated = {}", one_of(random, {"true", "false"}));
    }

    static std::string top_of(const Drawn& body) {
        return fmt::format("{{r_m = [{1:.17g}, {0:.17g}], z_m = [{2:.17g}, {2:.17g}]}}",
                           body.across.from, body.across.to, body.up.to);
    }

    // Along the sides that face each other.
    void penalty(const Drawn& stiff, const Drawn& soft) {
        line("law = \"penalty\"\nmodulus_kPa = {:.17g}", std::max(stiff.modulus, soft.modulus));
        maybe(2, "stiffness_multiple = {:.17g}", random.log_uniform(0.1, 3.0));
        const auto bottom = [](const Drawn& body) {
            return fmt::format("{{r_m = [{0:.17g}, {1:.17g}], z_m = [{2:.17g}, {2:.17g}]}}",
                               body.across.from, body.across.to, body.up.from);
        };
        line("stiff_line = {}\nsoft_line = {}", top_of(stiff), bottom(soft));
    }

    void traction() {
        const Drawn& body = bodies.back();
        line("[[traction]]\nbody = \"{}\"\nedge = \"top\"", body.name);
        if (body.water) maybe(2, "acts_on = \"mixture\"");
        const double stress = random.log_uniform(0.1, 100.0);
        if (one_in(random, 2)) {
            line("stress_kPa = [{:.17g}]", stress);
            return;
        }
        const double duration = random.log_uniform(1e-4, 1.0);
        line("[traction.pulses]\npeak_kPa = {:.17g}\nduration_s = {:.17g}\ncount = {}", stress,
             duration, 1 + random.below(3));
    }

    Random& random;
    MpmCase out;
    Geometry geometry = plane;
    double cell = 1.0, from = 0.0;
    std::vector<int> cells;
    bool absorbs = false, usl = true;
    std::vector<Drawn> bodies;
};

}  // namespace

MpmCase random_mpm_case(Random& random) { return Writer(random).write(); }

}  // namespace robustness
