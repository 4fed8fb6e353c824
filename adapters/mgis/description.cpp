// SPDX-License-Identifier: BSD-3-Clause
// What a host reads before it calls: names, types and sizes, found by the names of these symbols.
#include <cstddef>
#include <iterator>

#include "adapters/mgis/parameters.hpp"

namespace {

using Text = const char*;
using Count = unsigned short;
using NoNames = const char* const*;
using NoTypes = const int*;

template <typename T, std::size_t n> constexpr Count count(const T (&)[n]) { return n; }

constexpr int scalar = 0;
constexpr int symmetric_tensor = 1;
constexpr int real_parameter = 0;
constexpr int integer_parameter = 1;

}  // namespace

// Constants of a namespace are internal unless declared first.
#define GRIT_SYMBOL(type, name, value)                                                             \
    extern __attribute__((visibility("default"))) const type GritSand_##name;                      \
    const type GritSand_##name = value
#define GRIT_SYMBOLS(type, name, ...)                                                              \
    extern __attribute__((visibility("default"))) const type GritSand_##name[];                    \
    const type GritSand_##name[] = {__VA_ARGS__}

extern "C" {

GRIT_SYMBOL(Count, mfront_mkt, 1);  // a behaviour
GRIT_SYMBOL(Count, api_version, 1);
GRIT_SYMBOL(Text, mfront_interface, "Generic");

GRIT_SYMBOLS(Text, ModellingHypotheses, "Tridimensional", "Axisymmetrical", "PlaneStrain",
             "GeneralisedPlaneStrain");
GRIT_SYMBOL(Count, nModellingHypotheses, count(GritSand_ModellingHypotheses));

GRIT_SYMBOL(Count, BehaviourType, 1);       // standard strain based
GRIT_SYMBOL(Count, BehaviourKinematic, 1);  // small strain
GRIT_SYMBOL(Count, SymmetryType, 0);        // isotropic: the host hands over no material axes
GRIT_SYMBOL(Count, ElasticSymmetryType, 0);
GRIT_SYMBOL(Count, requiresStiffnessTensor, 0);
GRIT_SYMBOL(Count, requiresThermalExpansionCoefficientTensor, 0);
GRIT_SYMBOL(Count, UsableInPurelyImplicitResolution, 1);
GRIT_SYMBOL(Count, ComputesInternalEnergy, 0);  // the sand has no potential
GRIT_SYMBOL(Count, ComputesDissipatedEnergy, 1);

GRIT_SYMBOLS(Text, Gradients, "Strain");
GRIT_SYMBOLS(int, GradientsTypes, symmetric_tensor);
GRIT_SYMBOL(Count, nGradients, count(GritSand_Gradients));

GRIT_SYMBOLS(Text, ThermodynamicForces, "Stress");
GRIT_SYMBOLS(int, ThermodynamicForcesTypes, symmetric_tensor);
GRIT_SYMBOL(Count, nThermodynamicForces, count(GritSand_ThermodynamicForces));

GRIT_SYMBOLS(Text, TangentOperatorBlocks, "Stress", "Strain");
GRIT_SYMBOL(Count, nTangentOperatorBlocks, count(GritSand_TangentOperatorBlocks));

// In the order of PROPS of the classic layout (grit/classic_layout.h).
GRIT_SYMBOLS(Text, MaterialProperties, "CriticalFrictionAngle", "PressureShift",
             "GranulateHardness", "StiffnessExponent", "DensestVoidRatio", "CriticalVoidRatio",
             "LoosestVoidRatio", "PyknotropyExponent", "StiffnessVoidExponent", "ReversalStiffness",
             "TransverseStiffness", "ElasticStrainRadius", "EvolutionExponent",
             "StiffnessInterpolationExponent", "WaterStiffness", "InitialVoidRatio");
GRIT_SYMBOL(Count, nMaterialProperties, count(GritSand_MaterialProperties));

// In the order of StateVariables (state_variables.hpp).
GRIT_SYMBOLS(Text, InternalStateVariables, "IntergranularStrain", "VoidRatio", "Separation",
             "ExcessPorePressure", "FirstSubstep");
GRIT_SYMBOLS(int, InternalStateVariablesTypes, symmetric_tensor, scalar, scalar, scalar, scalar);
GRIT_SYMBOL(Count, nInternalStateVariables, count(GritSand_InternalStateVariables));

// The temperature, which every host of MGIS passes first, is not looked at.
GRIT_SYMBOL(Count, TemperatureRemovedFromExternalStateVariables, 1);
GRIT_SYMBOL(Count, nExternalStateVariables, 0);
GRIT_SYMBOL(NoNames, ExternalStateVariables, nullptr);
GRIT_SYMBOL(NoTypes, ExternalStateVariablesTypes, nullptr);

GRIT_SYMBOLS(Text, Parameters, "tolerance", "minimal_time_step_scaling_factor",
             "largest_water_tension", "evaluation_limit", "water_itself");
GRIT_SYMBOLS(int, ParametersTypes, real_parameter, real_parameter, real_parameter,
             integer_parameter, integer_parameter);
GRIT_SYMBOL(Count, nParameters, count(GritSand_Parameters));
GRIT_SYMBOL(double, tolerance_ParameterDefaultValue, grit::mgis::default_tolerance);
GRIT_SYMBOL(double, minimal_time_step_scaling_factor_ParameterDefaultValue,
            grit::mgis::default_smallest_reduction);
GRIT_SYMBOL(double, largest_water_tension_ParameterDefaultValue, 0.0);
GRIT_SYMBOL(int, evaluation_limit_ParameterDefaultValue, grit::mgis::default_evaluation_limit);
GRIT_SYMBOL(int, water_itself_ParameterDefaultValue, 0);

GRIT_SYMBOL(Count, nInitializeFunctions, 0);
GRIT_SYMBOL(NoNames, InitializeFunctions, nullptr);
GRIT_SYMBOL(Count, nPostProcessings, 0);
GRIT_SYMBOL(NoNames, PostProcessings, nullptr);
}
