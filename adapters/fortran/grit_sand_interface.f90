! SPDX-License-Identifier: BSD-3-Clause
! The sand as C has it: grit/sand.h, grit/sand_water.h, grit/sand_derivatives.h, grit/sand_operators.h,
! grit/sand_catalogue.h. Places in a state count from 1. 6 x 6 matrices are row-major here; module grit turns them.
module grit_sand_interface
   use, intrinsic :: iso_c_binding
   use grit_base, only: grit_error, grit_view, grit_matrix_view, grit_mutable_view, &
                        grit_mutable_matrix_view
   implicit none
   public

   integer(c_int), parameter :: grit_sand_critical_friction_angle = 0
   integer(c_int), parameter :: grit_sand_granulate_hardness = 1
   integer(c_int), parameter :: grit_sand_stiffness_exponent = 2
   integer(c_int), parameter :: grit_sand_densest_void_ratio = 3
   integer(c_int), parameter :: grit_sand_critical_void_ratio = 4
   integer(c_int), parameter :: grit_sand_loosest_void_ratio = 5
   integer(c_int), parameter :: grit_sand_pyknotropy_exponent = 6
   integer(c_int), parameter :: grit_sand_stiffness_void_exponent = 7
   integer(c_int), parameter :: grit_sand_pressure_shift = 8
   integer(c_int), parameter :: grit_sand_reversal_stiffness = 9
   integer(c_int), parameter :: grit_sand_transverse_stiffness = 10
   integer(c_int), parameter :: grit_sand_elastic_strain_radius = 11
   integer(c_int), parameter :: grit_sand_evolution_exponent = 12
   integer(c_int), parameter :: grit_sand_stiffness_interpolation_exponent = 13
   integer(c_int), parameter :: grit_sand_parameter_count = 14
   integer(c_int), parameter :: grit_sand_h11 = 1, grit_sand_h22 = 2, grit_sand_h33 = 3
   integer(c_int), parameter :: grit_sand_h12 = 4, grit_sand_h13 = 5, grit_sand_h23 = 6
   integer(c_int), parameter :: grit_sand_void_ratio = 7, grit_sand_separation = 8
   integer(c_int), parameter :: grit_sand_state_size = 8
   integer(c_int), parameter :: grit_tangent_none = 0, grit_tangent_continuum = 1
   integer(c_int), parameter :: grit_tangent_consistent = 2
   integer(c_int), parameter :: grit_sand_stress_free = 1, grit_sand_void_clamped = 2
   integer(c_int), parameter :: grit_sand_outside_cone = 4, grit_sand_h_clamped = 8
   integer(c_int), parameter :: grit_sand_cavitated = 16
   integer(c_int), parameter :: grit_sand_no_parameter = -1
   integer(c_int), parameter :: grit_sand_largest_direction_count = 32

   ! Angle in radians, stresses in any one unit; see grit/sand.h for ranges.
   type, bind(c) :: grit_sand_parameters
      integer(c_size_t) :: struct_size = 120
      real(c_double) :: critical_friction_angle  ! phi_c [rad]
      real(c_double) :: granulate_hardness       ! h_s [stress]
      real(c_double) :: stiffness_exponent       ! n [-]
      real(c_double) :: densest_void_ratio       ! e_d0 [-]
      real(c_double) :: critical_void_ratio      ! e_c0 [-]
      real(c_double) :: loosest_void_ratio       ! e_i0 [-]
      real(c_double) :: pyknotropy_exponent      ! alpha [-]
      real(c_double) :: stiffness_void_exponent  ! beta [-]
      real(c_double) :: pressure_shift           ! p_t [stress]
      real(c_double) :: reversal_stiffness       ! m_R [-]
      real(c_double) :: transverse_stiffness     ! m_T [-]
      real(c_double) :: elastic_strain_radius    ! R [-]
      real(c_double) :: evolution_exponent       ! beta_r [-]
      real(c_double) :: stiffness_interpolation_exponent  ! chi [-]
   end type

   type, bind(c) :: grit_sand_parameter_info
      type(c_ptr) :: name, symbol, unit  ! grit_text reads them
      real(c_double) :: lowest, highest
      integer(c_int) :: optional
   end type

   type, bind(c) :: grit_sand
      real(c_double) :: opaque(64) = 0
   end type

   type, bind(c) :: grit_sand_options
      integer(c_size_t) :: struct_size = 40
      real(c_double) :: tolerance
      integer(c_int) :: evaluation_limit, intergranular_off, tangent, instruction_set
      integer(c_int) :: stress_is_rotated, validate_only
   end type

   type, bind(c) :: grit_sand_points
      integer(c_size_t) :: struct_size = 176
      integer(c_int) :: components = 0, reserved = 0
      type(c_ptr) :: index = c_null_ptr
      type(grit_view) :: strain_increment, rotation_increment
      type(grit_mutable_view) :: stress, state
      type(grit_mutable_matrix_view) :: tangent
      type(grit_mutable_view) :: substep
   end type

   ! Of undrained points, see grit/sand_water.h; set by name after grit_sand_water_init.
   type, bind(c) :: grit_sand_water
      integer(c_size_t) :: struct_size = 80
      real(c_double) :: bulk_modulus     ! K_w [stress], of the water
      real(c_double) :: porosity         ! n [-], constant; 0: that of the void ratio
      real(c_double) :: largest_tension  ! [stress]
      type(grit_mutable_view) :: pore_pressure, total_stress
   end type

   ! Columns of the views are directions, see grit/sand_derivatives.h; parameters count from 0.
   type, bind(c) :: grit_sand_derivatives
      integer(c_size_t) :: struct_size = 120
      integer(c_int) :: count = 0, reserved = 0
      type(c_ptr) :: parameters = c_null_ptr
      type(grit_matrix_view) :: strain_increment
      type(grit_mutable_matrix_view) :: stress, state
   end type

   type, bind(c) :: grit_sand_report
      integer(c_int) :: status = 0, flags = 0, substeps = 0, evaluations = 0
      real(c_double) :: error_estimate = 0, step_reduction = 1, reserved(2) = 0
   end type

   type, bind(c) :: grit_sand_record
      type(c_ptr) :: name, title, status, source, note  ! grit_text reads them
   end type

   type, bind(c) :: grit_sand_scalar_factors
      integer(c_size_t) :: struct_size = 56
      real(c_double) :: a, F, f_d, f_e, f_b, f_s
   end type

   type, bind(c) :: grit_sand_invariants
      integer(c_size_t) :: struct_size = 64
      real(c_double) :: p, q, lode_angle, tan_psi, mobilised_friction_angle, rho, relative_density
   end type

   interface
      integer(c_int) function c_sand_parameters_init(parameters, struct_size) &
         bind(c, name='grit_sand_parameters_init')
         import
         type(grit_sand_parameters), intent(inout) :: parameters
         integer(c_size_t), value :: struct_size
      end function
      type(c_ptr) function c_sand_parameter_describe(index) &
         bind(c, name='grit_sand_parameter_describe')
         import
         integer(c_int), value :: index
      end function
      integer(c_int) function c_sand_parameter_get(parameters, index, value) &
         bind(c, name='grit_sand_parameter_get')
         import
         type(grit_sand_parameters), intent(in) :: parameters
         integer(c_int), value :: index
         real(c_double), intent(inout) :: value
      end function
      integer(c_int) function c_sand_parameter_set(parameters, index, value) &
         bind(c, name='grit_sand_parameter_set')
         import
         type(grit_sand_parameters), intent(inout) :: parameters
         integer(c_int), value :: index
         real(c_double), value :: value
      end function
      integer(c_int) function grit_sand_prepare(parameters, sand, error) bind(c)
         import
         type(grit_sand_parameters), intent(in) :: parameters
         type(grit_sand), intent(inout) :: sand
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function grit_sand_parameters_of(sand, parameters) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         type(grit_sand_parameters), intent(inout) :: parameters
      end function
      integer(c_int) function c_sand_options_init(options, struct_size) &
         bind(c, name='grit_sand_options_init')
         import
         type(grit_sand_options), intent(inout) :: options
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function c_sand_update(sand, options, n, points, reports, error) &
         bind(c, name='grit_sand_update')
         import
         type(grit_sand), intent(in) :: sand
         type(grit_sand_options), intent(in), optional :: options
         integer(c_ptrdiff_t), value :: n
         type(grit_sand_points), intent(in) :: points
         type(grit_sand_report), intent(inout), optional :: reports(*)
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_sand_water_init(water, struct_size) &
         bind(c, name='grit_sand_water_init')
         import
         type(grit_sand_water), intent(inout) :: water
         integer(c_size_t), value :: struct_size
      end function
      integer(c_int) function grit_sand_water_stiffness(water, pore_pressure, void_ratio, stiffness) &
         bind(c)
         import
         type(grit_sand_water), intent(in) :: water
         real(c_double), value :: pore_pressure, void_ratio
         real(c_double), intent(inout) :: stiffness
      end function
      integer(c_int) function c_sand_update_undrained(sand, options, water, n, points, reports, &
                                                      error) &
         bind(c, name='grit_sand_update_undrained')
         import
         type(grit_sand), intent(in) :: sand
         type(grit_sand_options), intent(in), optional :: options
         type(grit_sand_water), intent(in) :: water
         integer(c_ptrdiff_t), value :: n
         type(grit_sand_points), intent(in) :: points
         type(grit_sand_report), intent(inout), optional :: reports(*)
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_sand_update_differentiated(sand, options, derivatives, n, points, &
                                                           reports, error) &
         bind(c, name='grit_sand_update_differentiated')
         import
         type(grit_sand), intent(in) :: sand
         type(grit_sand_options), intent(in), optional :: options
         type(grit_sand_derivatives), intent(in) :: derivatives
         integer(c_ptrdiff_t), value :: n
         type(grit_sand_points), intent(in) :: points
         type(grit_sand_report), intent(inout), optional :: reports(*)
         type(grit_error), intent(inout), optional :: error
      end function

      integer(c_int) function grit_sand_record_count() bind(c)
         import
      end function
      type(c_ptr) function c_sand_record_at(index) bind(c, name='grit_sand_record_at')
         import
         integer(c_int), value :: index
      end function
      integer(c_int) function c_sand_record_find(name) bind(c, name='grit_sand_record_find')
         import
         character(kind=c_char), intent(in) :: name(*)
      end function
      integer(c_int) function grit_sand_record_parameters(index, stress_scale, parameters) bind(c)
         import
         integer(c_int), value :: index
         real(c_double), value :: stress_scale  ! 1 gives kPa, 1000 Pa
         type(grit_sand_parameters), intent(inout) :: parameters
      end function

      integer(c_int) function grit_sand_void_ratios(sand, p, void_ratios) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), value :: p
         real(c_double), intent(inout) :: void_ratios(3)  ! e_i, e_c, e_d
      end function
      integer(c_int) function grit_sand_factors(sand, stress, void_ratio, factors) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), intent(in) :: stress(6)
         real(c_double), value :: void_ratio
         type(grit_sand_scalar_factors), intent(inout) :: factors
      end function
      integer(c_int) function c_sand_stiffness(sand, stress, void_ratio, L, N) &
         bind(c, name='grit_sand_stiffness')
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), intent(in) :: stress(6)
         real(c_double), value :: void_ratio
         real(c_double), intent(inout), optional :: L(36), N(6)
      end function
      integer(c_int) function c_sand_intergranular_stiffness(sand, stress, state, D, M) &
         bind(c, name='grit_sand_intergranular_stiffness')
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), intent(in) :: stress(6), state(8), D(6)
         real(c_double), intent(inout) :: M(36)
      end function
      integer(c_int) function grit_sand_rate(sand, intergranular_off, stress, state, D, &
                                             stress_rate, state_rate) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         integer(c_int), value :: intergranular_off
         real(c_double), intent(in) :: stress(6), state(8), D(6)
         real(c_double), intent(inout) :: stress_rate(6), state_rate(8)
      end function
      integer(c_int) function grit_sand_wave_modulus(sand, intergranular_off, stress, void_ratio, &
                                                     modulus) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         integer(c_int), value :: intergranular_off
         real(c_double), intent(in) :: stress(6)
         real(c_double), value :: void_ratio
         real(c_double), intent(inout) :: modulus
      end function
      integer(c_int) function grit_sand_wave_moduli(sand, options, n, points, moduli, error) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         type(grit_sand_options), intent(in), optional :: options
         integer(c_ptrdiff_t), value :: n
         type(grit_sand_points), intent(in) :: points
         real(c_double), intent(inout) :: moduli(*)
         type(grit_error), intent(inout), optional :: error
      end function
      integer(c_int) function c_sand_rotate(Q, stress, state) bind(c, name='grit_sand_rotate')
         import
         real(c_double), intent(in) :: Q(9)
         real(c_double), intent(inout), optional :: stress(6), state(8)
      end function
      integer(c_int) function grit_sand_invariants_of(sand, stress, state, invariants) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), intent(in) :: stress(6), state(8)
         type(grit_sand_invariants), intent(inout) :: invariants
      end function
      integer(c_int) function grit_sand_void_ratio_at_pressure(sand, e_0, p, void_ratio) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), value :: e_0, p
         real(c_double), intent(inout) :: void_ratio
      end function
      integer(c_int) function c_sand_stress_at_rest(sand, unit_weight, depth, surcharge, K0, axis, &
                                                    stress) bind(c, name='grit_sand_stress_at_rest')
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), value :: unit_weight, depth, surcharge, K0
         integer(c_int), value :: axis
         real(c_double), intent(inout) :: stress(6)
      end function
      integer(c_int) function grit_sand_mobilise(sand, direction, rho, state) bind(c)
         import
         type(grit_sand), intent(in) :: sand
         real(c_double), intent(in) :: direction(6)
         real(c_double), value :: rho
         real(c_double), intent(inout) :: state(8)
      end function
   end interface
end module
