# SPDX-License-Identifier: BSD-3-Clause
# Signatures for editors and type checkers; tests/python/stubs.py holds them to the module.
from collections.abc import Sequence
from typing import Any

from numpy.typing import ArrayLike, NDArray

from grit import stage as stage

# Float64, changed in place, never copied; of lists of nodes and particles, labels and bits integers, of index int64.
Array = NDArray[Any]

__version__: str
__commit__: str
CAVITATED: int
H_CLAMPED: int
INACTIVE: int
OPEN: int
OUTSIDE_CONE: int
PENALTY_OPEN: int
PENALTY_SLIP: int
PENALTY_STICK: int
SEPARATION: int
SLIP: int
STATE_SIZE: int
STICK: int
STRESS_FREE: int
VOID_CLAMPED: int
VOID_RATIO: int

class Error(Exception):
    status: int
    point: int

class BadCall(Error, ValueError): ...
class BadParameter(Error, ValueError): ...
class BadState(Error, ValueError): ...
class InternalError(Error, RuntimeError): ...
class NotConverged(Error, ArithmeticError):
    reports: Array  # of updates and contact_correct
    history: dict[str, Array]  # of element_test
    normal: Array  # of contact_normals_by_regression

class Sand:
    def __init__(self, name: str | None = None, stress_scale: float = 1.0, **parameters: float) -> None: ...
    @staticmethod
    def from_props(props: Array | list[float], layout: str = "classic") -> Sand: ...
    @property
    def parameters(self) -> dict[str, float]: ...
    def update(
        self, strain_increment: Array, stress: Array, state: Array, *, tangent: Array | None = None,
        rotation_increment: Array | None = None, substep: Array | None = None, index: Array | None = None,
        continuum: bool = False, tolerance: float = 0.0002, evaluation_limit: int = 20000,
        intergranular_strain: bool = True, stress_is_rotated: bool = False, validate_only: bool = False,
    ) -> Array: ...
    def update_undrained(
        self, strain_increment: Array, stress: Array, state: Array, pore_pressure: Array, *,
        bulk_modulus: float, porosity: float = 0.0, largest_tension: float = ...,
        total_stress: Array | None = None, tangent: Array | None = None,
        rotation_increment: Array | None = None, substep: Array | None = None, index: Array | None = None,
        continuum: bool = False, tolerance: float = 0.0002, evaluation_limit: int = 20000,
        intergranular_strain: bool = True, stress_is_rotated: bool = False, validate_only: bool = False,
    ) -> Array: ...
    def update_differentiated(
        self, strain_increment: Array, stress: Array, state: Array, stress_slope: Array, state_slope: Array,
        *, parameters: Sequence[str | None], strain_increment_slope: Array | None = None,
        rotation_increment: Array | None = None, substep: Array | None = None, index: Array | None = None,
        tolerance: float = 0.0002, evaluation_limit: int = 20000, intergranular_strain: bool = True,
        stress_is_rotated: bool = False, validate_only: bool = False,
    ) -> Array: ...
    def slopes(
        self, parameters: Sequence[str | None], n: int | None = None, *, components: int = 6,
    ) -> tuple[Array, Array]: ...
    def state(self, void_ratio: float, direction: ArrayLike | None = None, rho: float = 1.0) -> Array: ...
    def stiffness(self, stress: ArrayLike, void_ratio: float) -> tuple[Array, Array]: ...
    def rate(
        self, stress: ArrayLike, state: ArrayLike, D: ArrayLike, intergranular_strain: bool = True,
    ) -> tuple[Array, Array]: ...
    def invariants(self, stress: ArrayLike, state: ArrayLike) -> dict[str, Any]: ...
    def void_ratios(self, p: float) -> tuple[float, float, float]: ...
    def void_ratio_at_pressure(self, e_0: float, p: float) -> float: ...
    def wave_modulus(self, stress: ArrayLike, void_ratio: float, intergranular_strain: bool = True) -> float: ...
    def stress_at_rest(
        self, unit_weight: float, depth: float, surcharge: float = 0.0, K0: float = -1.0, axis: int = 2,
    ) -> Array: ...

class ContactSurfaces:
    def __init__(self, position: Array, normal: Array, centres: bool = False) -> None: ...
    @property
    def surface(self) -> Array: ...
    @property
    def centre(self) -> Array | None: ...
    def add(
        self, body: str, position: Array, node: Array, *, offset: Array | None = None, side: Array | None = None,
    ) -> None: ...
    def merge(self, other: ContactSurfaces) -> None: ...
    def distance(self, stiffer: str, measure: str = 'support') -> Array: ...
    def gap(self) -> Array: ...

def contact_correct(
    mass_a: Array, mass_b: Array, normal: Array, velocity_a: Array, velocity_b: Array, *,
    distance: Array | None = None, cell_size: Array | None = None, spacing: Array | None = None,
    gap: Array | None = None, contact_area: Array | None = None, pore_impulse: Array | None = None,
    acceleration_a: Array | None = None, acceleration_b: Array | None = None, index: Array | None = None,
    law: str = 'geo', penalty_power: float = 6.0, friction_coefficient: float = 0.0,
    adhesion: float = 0.0, time_step: float = 0.0, relaxation_time: float = 0.0,
    contact_stiffness: float = 0.0, rigid: str | None = None, allow_zero_normal: bool = False,
) -> Array: ...
def contact_normals(
    source: str, *, gradient_a: Array | None = None, gradient_b: Array | None = None, given: Array | None = None,
    scale: Array | None = None, threshold: float = 0.0, fixed: Array | None = None,
) -> Array: ...
def contact_normals_by_regression(
    position: Array, body: Array, offset: Array, particle: Array | None = None, *, length: float,
    weight: Array | None = None, ridge: float = 0.0, iteration_limit: int = 0, fixed: Array | None = None,
) -> Array: ...
def element_test(
    sand: Sand, stages: stage.Stage | Sequence[stage.Stage], stress: ArrayLike, void_ratio: float,
    direction: ArrayLike | None = ..., rho: float = 1.0, tolerance: float = 0.0002,
    intergranular_strain: bool | None = None, parameters: Sequence[str] = ...,
    stress_slope: ArrayLike | None = None, void_ratio_slope: ArrayLike | None = None,
) -> dict[str, Any]: ...
def penalty_factor(s: float, d: float, k: float = 6.0) -> float: ...
def penalty_flush_stiffness(
    position: Array, *, normal_stiffness: float, tangential_stiffness: float = 0.0, friction_coefficient: float = 0.0,
    closed: bool = False, axisymmetric: bool = False,
) -> Array: ...
def penalty_forces(
    position_a: Array, position_b: Array, *, normal_stiffness: float, depth_max: float,
    tangential_stiffness: float = 0.0, friction_coefficient: float = 0.0, time_step: float = 0.0,
    velocity_a: Array | None = None, velocity_b: Array | None = None, history_a: Array | None = None,
    history_b: Array | None = None, closed_a: bool = False, closed_b: bool = False, axisymmetric: bool = False,
) -> dict[str, Any]: ...
def penalty_remesh(
    position: Array, *, longest: float, shortest: float = 0.0, tolerance: float = 0.0, closed: bool = False,
    history: Array | None = None,
) -> dict[str, Array]: ...
def penalty_stable_step(
    mass_a: Array, stiffness_a: Array, mass_b: Array | None = None, stiffness_b: Array | None = None,
) -> float: ...
def penalty_stiffness(multiple: float, modulus: float, cell_size: float) -> float: ...
def sands() -> dict[str, Any]: ...
