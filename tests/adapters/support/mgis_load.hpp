// SPDX-License-Identifier: BSD-3-Clause
// A host of MGIS as far as a behaviour sees it: the loader that walks the symbols of a library and
// believes nothing it has not read there, and the structures of a call, declared once more.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace mgis_host {

struct StateView {
    double* gradients;
    double* thermodynamic_forces;
    double* mass_density;
    double* material_properties;
    double* internal_state_variables;
    double* stored_energy;
    double* dissipated_energy;
    double* external_state_variables;
};

struct BehaviourDataView {
    char* error_message;
    double dt;
    double* K;
    double* rdt;
    double* speed_of_sound;
    StateView s0, s1;
};

struct Variable {
    std::string name;
    int type;  // 0 scalar, 1 symmetric tensor
};

using Integrate = int (*)(BehaviourDataView*);

struct Behaviour {
    std::string hypothesis;
    int components = 0;  // of a symmetric tensor
    Integrate integrate = nullptr;
    std::vector<Variable> gradients, forces, state_variables, external_variables;
    std::vector<std::string> properties, operator_blocks;
    std::vector<std::string> real_parameters, integer_parameters;
    std::vector<double> real_defaults;
    std::vector<int> integer_defaults;
    bool stored_energy = false, dissipated_energy = false;
    int (*set_real)(const char*, double) = nullptr;
    int (*set_integer)(const char*, int) = nullptr;
    std::set<std::string> symbols;  // all that were found

    int size_of(const std::vector<Variable>& variables) const;
    // Place of a state variable's first number; throws if there is none of that name.
    int place_of(const std::string& state_variable) const;
};

// Throws std::runtime_error with a sentence where the library does not keep to the interface.
Behaviour load(const std::string& library, const std::string& name, const std::string& hypothesis);

}  // namespace mgis_host
