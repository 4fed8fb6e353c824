// SPDX-License-Identifier: BSD-3-Clause
#include "support/mgis_load.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>

namespace mgis_host {
namespace {

class Symbols {
  public:
    Symbols(const std::string& library, std::string behaviour, std::string kind)
        : handle(dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL)), name(std::move(behaviour)),
          hypothesis(std::move(kind)) {
        if (!handle) throw std::runtime_error(dlerror());
    }

    void* find(const std::string& symbol) {
        void* found = dlsym(handle, symbol.c_str());
        if (found) seen.insert(symbol);
        return found;
    }
    // That of the hypothesis goes before that of all.
    template <typename T> const T* get(const std::string& what) {
        void* found = find(name + "_" + hypothesis + "_" + what);
        if (!found) found = find(name + "_" + what);
        if (!found) throw std::runtime_error("no symbol " + name + "_" + what);
        return static_cast<const T*>(found);
    }
    template <typename Function> Function function(const std::string& what) {
        void* found = find(name + "_" + what);
        if (!found) throw std::runtime_error("no function " + name + "_" + what);
        return reinterpret_cast<Function>(found);
    }
    unsigned short number(const std::string& what) { return *get<unsigned short>(what); }
    void expect(const std::string& what, unsigned short value) {
        if (number(what) != value)
            throw std::runtime_error(what + " is " + std::to_string(number(what)) + ", not " +
                                     std::to_string(value));
    }
    std::vector<std::string> names(const std::string& what) {
        const int n = number("n" + what);
        const auto* list = get<const char*>(what);
        return n == 0 ? std::vector<std::string>{} : std::vector<std::string>(list, list + n);
    }
    std::vector<Variable> variables(const std::string& what) {
        const auto list = names(what);
        const auto* types = get<int>(what + "Types");
        std::vector<Variable> out;
        for (std::size_t i = 0; i < list.size(); ++i) out.push_back({list[i], types[i]});
        return out;
    }
    const std::set<std::string>& all() const { return seen; }

  private:
    void* handle;
    std::string name, hypothesis;
    std::set<std::string> seen;
};

bool one_tensor(const std::vector<Variable>& variables, const char* name) {
    return variables.size() == 1 && variables[0].name == name && variables[0].type == 1;
}

void read_parameters(Symbols& symbols, Behaviour& b) {
    const auto names = symbols.names("Parameters");
    const auto* types = symbols.get<int>("ParametersTypes");
    for (std::size_t i = 0; i < names.size(); ++i) {
        const std::string default_value = names[i] + "_ParameterDefaultValue";
        if (types[i] == 0) {
            b.real_parameters.push_back(names[i]);
            b.real_defaults.push_back(*symbols.get<double>(default_value));
        } else if (types[i] == 1) {
            b.integer_parameters.push_back(names[i]);
            b.integer_defaults.push_back(*symbols.get<int>(default_value));
        } else {
            throw std::runtime_error("unknown type of parameter " + names[i]);
        }
    }
    b.set_real = symbols.function<int (*)(const char*, double)>("setParameter");
    b.set_integer = symbols.function<int (*)(const char*, int)>("setIntegerParameter");
}

// What is the same for every behaviour of this kind.
void check_kind(Symbols& symbols, const std::string& hypothesis) {
    symbols.expect("mfront_mkt", 1);
    symbols.expect("api_version", 1);
    symbols.expect("BehaviourType", 1);
    symbols.expect("BehaviourKinematic", 1);
    symbols.expect("SymmetryType", 0);
    symbols.expect("ElasticSymmetryType", 0);
    symbols.expect("requiresStiffnessTensor", 0);
    symbols.expect("requiresThermalExpansionCoefficientTensor", 0);
    symbols.expect("UsableInPurelyImplicitResolution", 1);
    if (*symbols.get<const char*>("mfront_interface") != std::string("Generic"))
        throw std::runtime_error("not of the generic interface");
    const auto hypotheses = symbols.names("ModellingHypotheses");
    if (std::find(hypotheses.begin(), hypotheses.end(), hypothesis) == hypotheses.end())
        throw std::runtime_error("not made for " + hypothesis);
}

}  // namespace

int Behaviour::size_of(const std::vector<Variable>& variables) const {
    int size = 0;
    for (const auto& variable : variables) size += variable.type == 0 ? 1 : components;
    return size;
}

int Behaviour::place_of(const std::string& state_variable) const {
    int place = 0;
    for (const auto& variable : state_variables) {
        if (variable.name == state_variable) return place;
        place += variable.type == 0 ? 1 : components;
    }
    throw std::runtime_error("no state variable " + state_variable);
}

Behaviour load(const std::string& library, const std::string& name, const std::string& hypothesis) {
    Symbols symbols(library, name, hypothesis);
    Behaviour b;
    b.hypothesis = hypothesis;
    b.components = hypothesis == "Tridimensional" ? 6 : 4;
    b.integrate = symbols.function<Integrate>(hypothesis);
    check_kind(symbols, hypothesis);
    b.gradients = symbols.variables("Gradients");
    b.forces = symbols.variables("ThermodynamicForces");
    if (!one_tensor(b.gradients, "Strain")) throw std::runtime_error("the gradient is not Strain");
    if (!one_tensor(b.forces, "Stress")) throw std::runtime_error("the force is not Stress");
    b.operator_blocks = symbols.names("TangentOperatorBlocks");
    if (b.operator_blocks != std::vector<std::string>{"Stress", "Strain"})
        throw std::runtime_error("the operator is not d Stress/d Strain");
    b.properties = symbols.names("MaterialProperties");
    b.state_variables = symbols.variables("InternalStateVariables");
    if (symbols.number("TemperatureRemovedFromExternalStateVariables") == 1)
        b.external_variables.push_back({"Temperature", 0});
    for (const auto& variable : symbols.variables("ExternalStateVariables"))
        b.external_variables.push_back(variable);
    b.stored_energy = symbols.number("ComputesInternalEnergy") == 1;
    b.dissipated_energy = symbols.number("ComputesDissipatedEnergy") == 1;
    read_parameters(symbols, b);
    if (!symbols.names("InitializeFunctions").empty() || !symbols.names("PostProcessings").empty())
        throw std::runtime_error("functions that nobody announced");
    b.symbols = symbols.all();
    return b;
}

}  // namespace mgis_host
