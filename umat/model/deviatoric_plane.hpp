// SPDX-License-Identifier: BSD-3-Clause
// Where a stress lies in the deviatoric plane, in closed form and to roundoff also where two principal
// values coincide. Tension positive. Not for kernels.
#pragma once

#include <cmath>

#include "umat/model/notation.hpp"

GRIT_KERNEL_BEGIN

// cosine + i sine of an angle.
struct Direction {
    double cosine, sine;
};

// The direction of a third of the angle of u, of unit length between -pi/2 and pi/2. A polynomial in the cosine
// is right to 2e-6, Halley's step z (z^3 + 2u) / (2z^3 + u) leaves the cube of that.
inline Direction third_of(const Direction& u) {
    const double x = u.cosine, x2 = x * x, x4 = x2 * x2;
    const auto polynomial = [&](double a, double b, double c, double d, double e, double f,
                                double g) {
        return (a + b * x) + x2 * (c + d * x) + x4 * ((e + f * x) + x2 * g);
    };
    const double re = polynomial(0.866025493418, 0.166657813616, -0.0479651670415, 0.0237345768168,
                                 -0.0124435327092, 0.00499553995154, -0.00100477511958);
    const double im =
        u.sine * polynomial(0.49999871142, -0.288547666207, 0.220084238404, -0.173009646501,
                            0.116960838169, -0.053779745355, 0.0116272759017);
    const double re3 = re * (re * re - 3.0 * im * im), im3 = im * (3.0 * re * re - im * im);
    const double a = re3 + 2.0 * u.cosine, b = im3 + 2.0 * u.sine;
    const double c = 2.0 * re3 + u.cosine, d = 2.0 * im3 + u.sine;
    const double q = 1.0 / (c * c + d * d);
    const double real = (a * c + b * d) * q, imaginary = (b * c - a * d) * q;
    return {re * real - im * imaginary, re * imaginary + im * real};
}

struct DeviatoricPlane {
    double length;    // of the deviator
    Direction about;  // of Lode's angle less pi/6

    // 0 where the middle value is the largest (triaxial compression) ... pi/3
    double lode_angle() const {
        constexpr double third_of_pi = 0x1.0c152382d7366p+0;
        return min(max(0.5 * third_of_pi + std::asin(about.sine), 0.0), third_of_pi);
    }
    double largest_less_smallest() const { return root_2 * length * about.cosine; }
    double middle() const { return -root_two_thirds * length * about.sine; }

  private:
    static constexpr double root_two_thirds = 0x1.a20bd700c2c3ep-1;
};

// With X the deviator of the cofactors of A = A*, |A| |X| = |A|^3/sqrt 6 and A:X = 3 det A = -|A||X| cos(3 angle).
// The sine comes from the part of X across A: as an angle between tensors it is exact to roundoff where the
// determinant alone would leave its square root.
inline DeviatoricPlane deviatoric_plane(const Tensor<double>& deviator_of_A) {
    constexpr double root_6 = 0x1.3988e1409212ep+1;
    const auto in_range = [](double square_of) { return square_of > 1e-70 && square_of < 1e70; };
    Tensor<double> A = deviator_of_A;
    double square_of_A = square(A), scale = 1.0;
    if (!in_range(square_of_A)) {  // its fourth power is wanted
        scale = 0.0;
        for (const double component : A.c) scale = max(scale, fabs(component));
        A = scaled(A, 1.0 / scale);
        square_of_A = square(A);
        if (!(scale > 1e-300 && in_range(square_of_A))) return {scale, third_of({0.0, -1.0})};
    }
    const Tensor<double> X = deviator(cofactors(A));
    const double along = contract(A, X);
    const double across = norm(scaled_sum(-along, A, scaled(X, square_of_A)));  // times |A|^2
    const double length = std::sqrt(square_of_A);
    const double unit = root_6 / (square_of_A * square_of_A);
    return {scale * length, third_of({across * unit, along * length * unit})};
}

GRIT_KERNEL_END
