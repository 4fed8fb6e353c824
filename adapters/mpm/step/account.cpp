// SPDX-License-Identifier: BSD-3-Clause
#include "adapters/mpm/step/account.hpp"

#include <array>
#include <stdexcept>
#include <string>

#include "adapters/mpm/step/text.hpp"

namespace grit::mpm {

// The first that is found; another process may have it.
void Account::report_lost(long count) const {
    std::string which;
    const Axis &r_axis = model.r, &z_axis = model.z;
    for (const Part& part : model.parts) {
        const Particles& q = part.body.particles;
        for (std::ptrdiff_t p = 0; p < q.size() && which.empty(); ++p) {
            const double r = q(column::r, p), z = q(column::z, p);
            const bool is_inside = r >= r_axis[0] && r <= r_axis[r_axis.nodes() - 1] &&
                                   z >= z_axis[0] && z <= z_axis[z_axis.nodes() - 1];
            if (is_inside) continue;
            which = ", among them particle " + std::to_string(q.ids()[p]) + " of body " +
                    part.body.name + " at " + place_text(r, z);
        }
    }
    throw std::runtime_error(std::to_string(count) + " particles left the grid at t = " +
                             std::to_string(model.t) + " s" + which);
}

// Sums of all strips in their order.
void Account::add_step(const Gather& gather, const Momentum& momentum, const Loads& loads,
                       const AbsorbingSides& sides, const Water& water) {
    enum {
        lost,
        external_work,
        traction_work,
        damping,
        viscosity,
        absorption,
        pic,
        transfer,
        pore_water,
        half,
        drag,
        on_walls,
        rigid_walls,
        implicit,
        carried,
        count
    };
    const bool fixed_point = model.settings.fixed_point;
    std::array<Total, count> step;
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        for (std::size_t s = 0; s < gather.strips(body).size(); ++s) {
            const Gather::OfStrip& strip = gather.strips(body)[s];
            const GatherSums& g = strip.sums;
            const NodeSums& n = momentum.sums(body)[s];
            step[lost].add(g.outside, fixed_point);
            (step[external_work] += g.body_work) += n.gravity_work;
            step[damping] += n.damping_work;
            step[viscosity] += strip.viscous_loss;
            step[half] += strip.half;
            step[pic] += g.pic_loss;
            (((step[transfer] += n.change) -= g.kept) += g.pic_loss) += n.mapped_away;
        }
    for (std::size_t body = 0; body < model.parts.size(); ++body)
        for (const WaterSums& w : water.sums(body)) {
            (step[external_work] += w.gravity_work) += w.side_work;
            step[pic] += w.pic_loss;
            (((step[transfer] += w.change) -= w.kept) += w.pic_loss) += w.mapped_away;
            step[pore_water] += w.work;
            step[half] += w.half;
            step[drag] += w.drag;
            step[implicit] += w.between;
            step[carried] += w.carried;
        }
    step[on_walls] += water.taken().contact;
    step[rigid_walls] += water.taken().rigid_work;
    step[implicit] += water.taken().implicit;
    step[external_work] += water.taken().side_work;
    (step[external_work] += loads.work()) += sides.held_work();
    step[traction_work] += loads.work();
    step[absorption] += sides.absorbed();
    model.exchange.sum(step, fixed_point);
    energies.external_work += step[external_work].value();
    energies.traction_work += step[traction_work].value();
    energies.damping += step[damping].value();
    energies.viscosity += step[viscosity].value();
    energies.absorbed += step[absorption].value();
    energies.pic += step[pic].value();
    energies.transfer += step[transfer].value();
    energies.pore_water += step[pore_water].value();
    energies.half = step[half].value();
    energies.drag += step[drag].value();
    energies.contact += step[on_walls].value();
    energies.rigid_work += step[rigid_walls].value();
    energies.implicit += step[implicit].value();
    energies.carried += step[carried].value();
    const double count_lost = step[lost].value();
    if (count_lost > 0.0) report_lost(static_cast<long>(count_lost));
    // Sums in fixed point have an end, beyond which they are no numbers.
    if (!fixed_point) energies.check_finite(model.t);
}

void Account::measure() {
    std::array<Total, 2> sums;  // kinetic, stored
    const bool fixed_point = model.settings.fixed_point;
    for (Part& part : model.parts) {
        if (part.body.rigid()) continue;
        const ParticleView q = part.body.particles.view();
        for (std::ptrdiff_t p = 0; p < part.body.particles.size(); ++p) {
            const double v_r = q[column::v_r][p], v_z = q[column::v_z][p];
            sums[0].add(0.5 * q[column::mass][p] * (v_r * v_r + v_z * v_z), fixed_point);
            if (part.body.water) sums[0].add(part.body.water->kinetic_energy(q, p), fixed_point);
            sums[1].add(part.body.material->energy(q, p), fixed_point);
        }
    }
    model.exchange.sum(sums, fixed_point);
    energies.kinetic = sums[0].value();
    energies.stored = sums[1].value();
}

void Account::start() {
    measure();
    energies.kinetic_0 = energies.kinetic;
    energies.stored_0 = energies.stored;
}

}  // namespace grit::mpm
