/* SPDX-License-Identifier: BSD-3-Clause */
#include "layout.h"

VALUE(GRIT_SAND_CRITICAL_FRICTION_ANGLE, 0);
VALUE(GRIT_SAND_GRANULATE_HARDNESS, 1);
VALUE(GRIT_SAND_STIFFNESS_EXPONENT, 2);
VALUE(GRIT_SAND_DENSEST_VOID_RATIO, 3);
VALUE(GRIT_SAND_CRITICAL_VOID_RATIO, 4);
VALUE(GRIT_SAND_LOOSEST_VOID_RATIO, 5);
VALUE(GRIT_SAND_PYKNOTROPY_EXPONENT, 6);
VALUE(GRIT_SAND_STIFFNESS_VOID_EXPONENT, 7);
VALUE(GRIT_SAND_PRESSURE_SHIFT, 8);
VALUE(GRIT_SAND_REVERSAL_STIFFNESS, 9);
VALUE(GRIT_SAND_TRANSVERSE_STIFFNESS, 10);
VALUE(GRIT_SAND_ELASTIC_STRAIN_RADIUS, 11);
VALUE(GRIT_SAND_EVOLUTION_EXPONENT, 12);
VALUE(GRIT_SAND_STIFFNESS_INTERPOLATION_EXPONENT, 13);
VALUE(GRIT_SAND_PARAMETER_COUNT, 14);
VALUE(GRIT_SAND_H11, 0);
VALUE(GRIT_SAND_H22, 1);
VALUE(GRIT_SAND_H33, 2);
VALUE(GRIT_SAND_H12, 3);
VALUE(GRIT_SAND_H13, 4);
VALUE(GRIT_SAND_H23, 5);
VALUE(GRIT_SAND_VOID_RATIO, 6);
VALUE(GRIT_SAND_SEPARATION, 7);
VALUE(GRIT_SAND_STATE_SIZE, 8);
VALUE(GRIT_SAND_NO_PARAMETER, -1);
VALUE(GRIT_SAND_LARGEST_DIRECTION_COUNT, 32);
VALUE(GRIT_TANGENT_NONE, 0);
VALUE(GRIT_TANGENT_CONTINUUM, 1);
VALUE(GRIT_TANGENT_CONSISTENT, 2);
VALUE(GRIT_SAND_STRESS_FREE, 1);
VALUE(GRIT_SAND_VOID_CLAMPED, 2);
VALUE(GRIT_SAND_OUTSIDE_CONE, 4);
VALUE(GRIT_SAND_H_CLAMPED, 8);
VALUE(GRIT_SAND_CAVITATED, 16);
VALUE(GRIT_OK, 0);
VALUE(GRIT_BAD_CALL, 1);
VALUE(GRIT_BAD_PARAMETER, 2);
VALUE(GRIT_BAD_STATE, 3);
VALUE(GRIT_NOT_CONVERGED, 4);
VALUE(GRIT_INTERNAL, 5);
VALUE(GRIT_MESSAGE_SIZE, 256);
VALUE(GRIT_ISA_BEST, 0);
VALUE(GRIT_ISA_BASELINE, 1);
VALUE(GRIT_ISA_AVX2, 2);
VALUE(GRIT_ISA_AVX512, 3);

#if defined(__LP64__)

SIZE(grit_sand_parameters, 120);
PLACE(grit_sand_parameters, struct_size, 0);
PLACE(grit_sand_parameters, critical_friction_angle, 8);
PLACE(grit_sand_parameters, granulate_hardness, 16);
PLACE(grit_sand_parameters, stiffness_exponent, 24);
PLACE(grit_sand_parameters, densest_void_ratio, 32);
PLACE(grit_sand_parameters, critical_void_ratio, 40);
PLACE(grit_sand_parameters, loosest_void_ratio, 48);
PLACE(grit_sand_parameters, pyknotropy_exponent, 56);
PLACE(grit_sand_parameters, stiffness_void_exponent, 64);
PLACE(grit_sand_parameters, pressure_shift, 72);
PLACE(grit_sand_parameters, reversal_stiffness, 80);
PLACE(grit_sand_parameters, transverse_stiffness, 88);
PLACE(grit_sand_parameters, elastic_strain_radius, 96);
PLACE(grit_sand_parameters, evolution_exponent, 104);
PLACE(grit_sand_parameters, stiffness_interpolation_exponent, 112);

SIZE(grit_sand_derivatives, 120);
PLACE(grit_sand_derivatives, struct_size, 0);
PLACE(grit_sand_derivatives, count, 8);
PLACE(grit_sand_derivatives, reserved, 12);
PLACE(grit_sand_derivatives, parameters, 16);
PLACE(grit_sand_derivatives, strain_increment, 24);
PLACE(grit_sand_derivatives, stress, 56);
PLACE(grit_sand_derivatives, state, 88);

SIZE(grit_sand_parameter_info, 48);
PLACE(grit_sand_parameter_info, name, 0);
PLACE(grit_sand_parameter_info, symbol, 8);
PLACE(grit_sand_parameter_info, unit, 16);
PLACE(grit_sand_parameter_info, lowest, 24);
PLACE(grit_sand_parameter_info, highest, 32);
PLACE(grit_sand_parameter_info, optional, 40);

SIZE(grit_sand, 512);
PLACE(grit_sand, opaque, 0);

SIZE(grit_sand_options, 40);
PLACE(grit_sand_options, struct_size, 0);
PLACE(grit_sand_options, tolerance, 8);
PLACE(grit_sand_options, evaluation_limit, 16);
PLACE(grit_sand_options, intergranular_off, 20);
PLACE(grit_sand_options, tangent, 24);
PLACE(grit_sand_options, instruction_set, 28);
PLACE(grit_sand_options, stress_is_rotated, 32);
PLACE(grit_sand_options, validate_only, 36);

SIZE(grit_sand_points, 176);
PLACE(grit_sand_points, struct_size, 0);
PLACE(grit_sand_points, components, 8);
PLACE(grit_sand_points, reserved, 12);
PLACE(grit_sand_points, index, 16);
PLACE(grit_sand_points, strain_increment, 24);
PLACE(grit_sand_points, rotation_increment, 48);
PLACE(grit_sand_points, stress, 72);
PLACE(grit_sand_points, state, 96);
PLACE(grit_sand_points, tangent, 120);
PLACE(grit_sand_points, substep, 152);

SIZE(grit_sand_water, 80);
PLACE(grit_sand_water, struct_size, 0);
PLACE(grit_sand_water, bulk_modulus, 8);
PLACE(grit_sand_water, porosity, 16);
PLACE(grit_sand_water, largest_tension, 24);
PLACE(grit_sand_water, pore_pressure, 32);
PLACE(grit_sand_water, total_stress, 56);

SIZE(grit_sand_report, 48);
PLACE(grit_sand_report, status, 0);
PLACE(grit_sand_report, flags, 4);
PLACE(grit_sand_report, substeps, 8);
PLACE(grit_sand_report, evaluations, 12);
PLACE(grit_sand_report, error_estimate, 16);
PLACE(grit_sand_report, step_reduction, 24);
PLACE(grit_sand_report, reserved, 32);

SIZE(grit_sand_record, 40);
PLACE(grit_sand_record, name, 0);
PLACE(grit_sand_record, title, 8);
PLACE(grit_sand_record, status, 16);
PLACE(grit_sand_record, source, 24);
PLACE(grit_sand_record, note, 32);

SIZE(grit_sand_scalar_factors, 56);
PLACE(grit_sand_scalar_factors, struct_size, 0);
PLACE(grit_sand_scalar_factors, a, 8);
PLACE(grit_sand_scalar_factors, F, 16);
PLACE(grit_sand_scalar_factors, f_d, 24);
PLACE(grit_sand_scalar_factors, f_e, 32);
PLACE(grit_sand_scalar_factors, f_b, 40);
PLACE(grit_sand_scalar_factors, f_s, 48);

SIZE(grit_sand_invariants, 64);
PLACE(grit_sand_invariants, struct_size, 0);
PLACE(grit_sand_invariants, p, 8);
PLACE(grit_sand_invariants, q, 16);
PLACE(grit_sand_invariants, lode_angle, 24);
PLACE(grit_sand_invariants, tan_psi, 32);
PLACE(grit_sand_invariants, mobilised_friction_angle, 40);
PLACE(grit_sand_invariants, rho, 48);
PLACE(grit_sand_invariants, relative_density, 56);

SIZE(grit_error, 272);
PLACE(grit_error, status, 0);
PLACE(grit_error, reserved, 4);
PLACE(grit_error, point, 8);
PLACE(grit_error, message, 16);

SIZE(grit_view, 24);
PLACE(grit_view, base, 0);
PLACE(grit_view, point_stride, 8);
PLACE(grit_view, component_stride, 16);

SIZE(grit_mutable_view, 24);
PLACE(grit_mutable_view, base, 0);
PLACE(grit_mutable_view, point_stride, 8);
PLACE(grit_mutable_view, component_stride, 16);

SIZE(grit_matrix_view, 32);
PLACE(grit_matrix_view, base, 0);
PLACE(grit_matrix_view, point_stride, 8);
PLACE(grit_matrix_view, row_stride, 16);
PLACE(grit_matrix_view, column_stride, 24);

SIZE(grit_mutable_matrix_view, 32);
PLACE(grit_mutable_matrix_view, base, 0);
PLACE(grit_mutable_matrix_view, point_stride, 8);
PLACE(grit_mutable_matrix_view, row_stride, 16);
PLACE(grit_mutable_matrix_view, column_stride, 24);

#endif
