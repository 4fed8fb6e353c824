// SPDX-License-Identifier: BSD-3-Clause
#include "cli/element/laboratory_words.hpp"

namespace cli {
namespace {

using namespace element;

constexpr Control E = Control::strain, S = Control::stress;  // prescribed

Step first(const Controls& controls, double change) {
    return component_control(controls, change * Vector6::Unit(0));
}

Step undrained(Step step) {
    step.undrained = true;
    return step;
}

Step shear_stress_constant_normal(double change) {
    return component_control({E, S, E, S, E, E}, change * Vector6::Unit(3));
}

Step shear_stress_constant_volume(double change) {
    return component_control({E, E, E, S, E, E}, change * Vector6::Unit(3));
}

Step biaxial_stress(double change) { return first({S, S, E, E, E, E}, change); }
Step biaxial_undrained(double strain) { return undrained(biaxial_drained(strain)); }
Step biaxial_undrained_stress(double change) { return undrained(biaxial_stress(change)); }

}  // namespace

std::string Way::amplitude_key() const {
    if (strain()) return key + "_amplitude";
    return key.substr(0, key.size() - 4) + "_amplitude_kPa";
}

const std::vector<LaboratoryTest>& laboratory_tests() {
    static const std::vector<Way> oedometric = {{"axial_strain", oedometer_strain},
                                                {"axial_stress_kPa", oedometer_stress, {0}}};
    static const std::vector<LaboratoryTest> tests = {
        {"isotropic",
         {{"pressure_kPa", isotropic_stress, {0, 1, 2}, -1.0},
          {"volumetric_strain", isotropic_strain}}},
        {"k0_consolidation", oedometric},
        {"oedometer", oedometric},
        {"triaxial_drained",
         {{"axial_strain", triaxial_drained}, {"axial_stress_kPa", triaxial_drained_stress, {0}}}},
        {"triaxial_undrained",
         {{"axial_strain", triaxial_undrained},
          {"axial_stress_kPa", triaxial_undrained_stress, {0}}}},
        {"triaxial_constant_p", {{"axial_strain", triaxial_constant_p}}},
        {"triaxial_constant_volume", {{"axial_strain", constant_volume_triaxial}}},
        {"biaxial_drained",
         {{"axial_strain", biaxial_drained}, {"axial_stress_kPa", biaxial_stress, {0}}}},
        {"biaxial_undrained",
         {{"axial_strain", biaxial_undrained},
          {"axial_stress_kPa", biaxial_undrained_stress, {0}}}},
        {"simple_shear_constant_stress",
         {{"shear_strain", simple_shear_constant_stress},
          {"shear_stress_kPa", shear_stress_constant_normal, {3}}},
         true},
        {"simple_shear_constant_volume",
         {{"shear_strain", simple_shear_constant_volume},
          {"shear_stress_kPa", shear_stress_constant_volume, {3}}},
         true},
    };
    return tests;
}

}  // namespace cli
