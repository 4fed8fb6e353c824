// SPDX-License-Identifier: BSD-3-Clause
#include "support/differentiated.hpp"
#include "support/states.hpp"

namespace {

using namespace tests;

struct StrainPath {
    Sand sand;
    Point start;
    std::vector<Vec> increments;
};

constexpr int of_R = GRIT_SAND_ELASTIC_STRAIN_RADIUS;

// At a parameter, an initial void ratio or, in its lengths, a component of every increment changed so much. The
// intergranular strain of the start is a share of R.
Numbers end_of(const StrainPath& path, const grit_sand_options& options, int direction,
               double change) {
    grit_sand_parameters p = path.sand.p;
    Point x = path.start;
    double value;
    if (direction < of_initial_void_ratio) {
        grit_sand_parameter_get(&p, direction, &value);
        grit_sand_parameter_set(&p, direction, value + change);
    } else if (direction == of_initial_void_ratio) x.state[GRIT_SAND_VOID_RATIO] += change;
    const Sand sand = prepared(path.sand.name, p);
    for (int c = 0; c < 6; ++c)
        x.state[c] *= p.elastic_strain_radius / path.sand.p.elastic_strain_radius;
    for (const Vec& dE : path.increments) {
        Voigt strain = voigt_strain(dE);
        if (direction >= of_strain)
            strain[static_cast<std::size_t>(direction - of_strain)] += change * dE.norm();
        const Outcome out = update(sand, x, strain.data(), options);
        EXPECT_EQ(out.status, GRIT_OK) << out.error.message;
    }
    return numbers_of(x);
}

// Central differences, extrapolated.
Numbers differences(const StrainPath& path, const grit_sand_options& options, int direction,
                    double step) {
    const auto central = [&](double h) -> Numbers {
        return (end_of(path, options, direction, h) - end_of(path, options, direction, -h)) /
               (2.0 * h);
    };
    return (4.0 * central(0.5 * step) - central(step)) / 3.0;
}

Differentiated differentiated(const StrainPath& path, const grit_sand_options& options) {
    const std::vector<int>& directions = all_directions();
    Differentiated x(path.start, static_cast<int>(directions.size()));
    x.slopes(6 + GRIT_SAND_VOID_RATIO, of_initial_void_ratio) = 1.0;
    for (int c = 0; c < 6; ++c)
        x.slopes(6 + c, of_R) = path.start.state[c] / path.sand.p.elastic_strain_radius;
    for (const Vec& dE : path.increments) {
        StrainSlopes slopes = StrainSlopes::Zero(6, x.slopes.cols());
        for (int c = 0; c < 6; ++c) slopes(c, of_strain + c) = dE.norm();
        const Outcome out =
            update(path.sand, x, voigt_strain(dE).data(), directions, slopes, options);
        EXPECT_EQ(out.status, GRIT_OK) << out.error.message;
    }
    return x;
}

// What a parameter, or the void ratio, or a strain is measured by.
double size_of(const Sand& sand, int direction) {
    double value = 1.0;
    if (direction < of_initial_void_ratio) grit_sand_parameter_get(&sand.p, direction, &value);
    return value;
}

// Difference of two derivatives by the size of the direction, and how large they are: of the stress over the
// stress, of h over R, of e.
struct Deviation {
    double stress, h, e;
};
Deviation deviation(const Sand& sand, const Numbers& end, const Numbers& a, const Numbers& b,
                    double size) {
    constexpr double least = 0.01;
    const auto of = [&](int first, int count, double scale) {
        return (a - b).segment(first, count).norm() * size /
               std::fmax(b.segment(first, count).norm() * size, least * scale);
    };
    return {of(0, 6, end.head<6>().norm()), of(6, 6, sand.p.elastic_strain_radius),
            of(12, 1, end[12])};
}

StrainPath random_path(const Sand& sand, Random& random, int count, double least, double largest) {
    StrainPath path{sand, {}, {}};
    path.start = point_of(random_state(sand, random, 50.0, 500.0));
    for (int i = 0; i < count; ++i)
        path.increments.push_back(random.log_uniform(least, largest) * random.direction());
    return path;
}

TEST(ParameterDerivatives, AreCentralDifferencesOfWholePaths) {
    Random random(201);
    for (const Sand& catalogue : four_sands()) {
        grit_sand_parameters p = catalogue.p;
        p.pressure_shift = 2.0;
        const Sand sand = prepared(catalogue.name, p);
        for (int i = 0; i < 10; ++i) {
            const StrainPath path = random_path(sand, random, 3, 1e-5, 1e-3);
            const grit_sand_options tight = options_with(1e-12);
            const Differentiated x = differentiated(path, tight);
            const Numbers end = numbers_of(x.point);
            for (int k = 0; k < x.slopes.cols(); ++k) {
                const double size = size_of(sand, k);
                const Numbers reference = differences(path, tight, k, 1e-3 * size);
                const Deviation d = deviation(sand, end, x.slopes.col(k), reference, size);
                EXPECT_LE(d.stress, 1e-6) << sand.name << ", path " << i << ", direction " << k;
                EXPECT_LE(d.h, 1e-6) << sand.name << ", path " << i << ", direction " << k;
                EXPECT_LE(d.e, 1e-6) << sand.name << ", path " << i << ", direction " << k;
            }
        }
    }
}

// Loose enough that an increment is one step a segment, whatever the probe does.
TEST(ParameterDerivatives, AreThoseOfTheStepsTaken) {
    Random random(202);
    int compared = 0;
    for (const Sand& sand : four_sands())
        for (int i = 0; i < 20; ++i) {
            const StrainPath path = random_path(sand, random, 1, 1e-6, 3e-5);
            const grit_sand_options loose = options_with(0.1);
            const Differentiated x = differentiated(path, loose);
            const Numbers end = numbers_of(x.point);
            for (int k = 0; k < x.slopes.cols(); ++k) {
                if (k == GRIT_SAND_PRESSURE_SHIFT) continue;  // p_t is 0: no way down
                const double size = size_of(sand, k);
                const Numbers reference = differences(path, loose, k, 1e-4 * size);
                const Deviation d = deviation(sand, end, x.slopes.col(k), reference, size);
                compared += std::fmax(d.stress, std::fmax(d.h, d.e)) <= 1e-6;
            }
        }
    EXPECT_GE(compared, 4 * 20 * 20 * 95 / 100);  // where the probe keeps the steps
}

TEST(ParameterDerivatives, ComeWithTheSameBitsAsWithout) {
    for (const Sand& sand : four_sands()) {
        Random random(203);
        for (int i = 0; i < 100; ++i) {
            const Point start = point_of(random_state(sand, random));
            const Voigt dE = voigt_strain(random.log_uniform(1e-8, 2e-2) * random.direction());
            Differentiated with(start, 21);
            Point without = start;
            update(sand, with, dE.data(), all_directions(), {}, options_with(1e-4));
            update(sand, without, dE.data(), options_with(1e-4));
            EXPECT_TRUE(same_bits(with.point, without)) << sand.name << " " << i;
        }
    }
}

TEST(ParameterDerivatives, OfADirectionDoNotDependOnTheOthers) {
    const Sand sand = sand_named("lausitz");
    Random random(204);
    const StrainPath path = random_path(sand, random, 3, 1e-5, 1e-3);
    const grit_sand_options options = options_with(1e-4);
    const Differentiated all = differentiated(path, options);
    for (int k = 0; k < of_strain; ++k) {
        Differentiated one(path.start, 1);
        one.slopes = Slopes::Zero(14, 1);
        if (k == of_initial_void_ratio) one.slopes(12, 0) = 1.0;
        if (k == of_R)
            for (int c = 0; c < 6; ++c)
                one.slopes(6 + c, 0) = path.start.state[c] / sand.p.elastic_strain_radius;
        for (const Vec& dE : path.increments)
            update(sand, one, voigt_strain(dE).data(),
                   {all_directions()[static_cast<std::size_t>(k)]}, {}, options);
        EXPECT_EQ((one.slopes.col(0) - all.slopes.col(k)).norm(), 0.0) << k;
    }
}

// Six directions of strain are the consistent tangent.
TEST(ParameterDerivatives, ByStrainAreTheConsistentTangent) {
    for (const Sand& sand : four_sands()) {
        Random random(205);
        for (int i = 0; i < 30; ++i) {
            const Point start = point_of(random_state(sand, random));
            const Vec dE = random.log_uniform(1e-6, 1e-2) * random.direction();
            Point with_tangent = start;
            const Outcome out = update(sand, with_tangent, voigt_strain(dE).data(),
                                       options_with(1e-4, GRIT_TANGENT_CONSISTENT));
            Differentiated x(start, 6);
            const StrainSlopes unit = StrainSlopes::Identity(6, 6);
            update(sand, x, voigt_strain(dE).data(), std::vector<int>(6, GRIT_SAND_NO_PARAMETER),
                   unit, options_with(1e-4));
            const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> C(out.tangent);
            EXPECT_LE((x.slopes.topRows<6>() - C).norm(), 1e-11 * C.norm()) << sand.name;
        }
    }
}

// Turned by a constant Q, all derivatives turn with the point.
TEST(ParameterDerivatives, TurnWithTheRotationIncrement) {
    const Sand sand = sand_named("hostun");
    Random random(206);
    for (int i = 0; i < 20; ++i) {
        const State x = random_state(sand, random);
        const Vec dE = 1e-3 * random.direction();
        const Full Q = random.rotation();
        const State turned{rotated(Q, x.T), rotated(Q, x.h), x.e};
        Slopes start(14, 3);
        for (int r = 0; r < 14; ++r)
            for (int k = 0; k < 3; ++k)
                start(r, k) = r < 6 ? random.normal() : 1e-5 * random.normal();
        start.row(13).setZero();
        const auto turn = [&](Slopes s) {
            for (int k = 0; k < 3; ++k) {
                const Numbers column = s.col(k);
                const Voigt T = voigt_stress(rotated(Q, stress_from(column.data()))),
                            h = voigt_strain(rotated(Q, strain_from(column.data() + 6)));
                for (int c = 0; c < 6; ++c)
                    s(c, k) = T[static_cast<std::size_t>(c)],
                         s(6 + c, k) = h[static_cast<std::size_t>(c)];
            }
            return s;
        };
        const std::vector<int> parameters = {0, 9, GRIT_SAND_NO_PARAMETER};
        Differentiated by_host(point_of(turned), 3), by_us(point_of(x), 3);
        by_host.slopes = turn(start);
        by_us.slopes = start;
        const Voigt strain = voigt_strain(dE);
        update(sand, by_host, strain.data(), parameters, {}, options_with());
        grit_sand_points q{};
        q.struct_size = sizeof q;
        q.strain_increment = grit_view_of(strain.data(), 6, 1);
        const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> rows = Q;
        q.rotation_increment = grit_view_of(rows.data(), 9, 1);
        q.stress = grit_mutable_view_of(by_us.point.stress, 6, 1);
        q.state = grit_mutable_view_of(by_us.point.state, 8, 1);
        grit_sand_derivatives d{};
        d.struct_size = sizeof d;
        d.count = 3;
        d.parameters = parameters.data();
        d.stress = grit_mutable_matrix_view_of(by_us.slopes.data(), 42, 3, 1);
        d.state = grit_mutable_matrix_view_of(by_us.slopes.data() + 18, 42, 3, 1);
        const grit_sand_options options = options_with();
        ASSERT_EQ(grit_sand_update_differentiated(sand, &options, &d, 1, &q, nullptr, nullptr),
                  GRIT_OK);
        for (int k = 0; k < 3; ++k)
            EXPECT_LE((by_us.slopes.col(k) - by_host.slopes.col(k)).norm(),
                      1e-9 * by_host.slopes.col(k).norm());
    }
}

// Closing a gap, pressing, opening another. Where a point opens is interpolated over the last step.
TEST(ParameterDerivatives, FollowSeparatedPoints) {
    const Sand sand = sand_named("lausitz");
    StrainPath path{sand, {}, {}};
    path.start.state[GRIT_SAND_VOID_RATIO] = 0.7;
    path.start.state[GRIT_SAND_SEPARATION] = 1e-4;
    const Vec I = identity() / 3.0, n = principal(1.0, -1.0, 0.0);
    const auto compare = [&] {
        const grit_sand_options tight = options_with(1e-12);
        const Differentiated x = differentiated(path, tight);
        const Numbers end = numbers_of(x.point);
        for (int k = 0; k < x.slopes.cols(); ++k) {
            if (k == GRIT_SAND_PRESSURE_SHIFT) continue;  // p_t is 0: no way down
            const double size = size_of(sand, k);
            const Numbers reference = size * differences(path, tight, k, 2e-4 * size);
            const Numbers error = size * x.slopes.col(k) - reference;
            EXPECT_LE(error.head<6>().norm(),
                      1e-6 * std::fmax(reference.head<6>().norm(), 0.1 * end.head<6>().norm()))
                << k;
            EXPECT_LE(std::fabs(error[12]), 1e-8) << k;
            EXPECT_LE(std::fabs(error[13]), 5e-3 * std::fabs(reference[13]) + 3e-5) << k;
        }
        return x;
    };
    path.increments = {-5e-5 * I, -2e-3 * I + 3e-4 * n};
    compare();
    path.increments.push_back(-3e-2 * I + 1e-2 * n);
    EXPECT_GT(numbers_of(compare().point).head<6>().norm(), 1.0);
    path.increments.push_back(4e-2 * I);
    const Differentiated opened = compare();
    EXPECT_GT(opened.point.state[GRIT_SAND_SEPARATION], 0.0);
    EXPECT_EQ(opened.slopes.topRows<12>().norm(), 0.0);
    path.increments.push_back(1e-3 * I);
    compare();
}

// It opens at once, whatever the sand is.
TEST(ParameterDerivatives, OfAPointThatSeparatesWhereItStartsAreNone) {
    const Sand sand = sand_named("lausitz");
    const double p_floor = 1e-8 * sand.p.granulate_hardness;
    for (const double p : {1.2 * p_floor, 1.5 * p_floor, 1.9 * p_floor}) {
        StrainPath path{sand, {}, {1e-3 * identity()}};
        path.start.state[GRIT_SAND_VOID_RATIO] = 0.7;
        for (int c = 0; c < 3; ++c) path.start.stress[c] = -p;
        const Differentiated x = differentiated(path, options_with(1e-12));
        ASSERT_GT(x.point.state[GRIT_SAND_SEPARATION], 0.0);
        for (int k = 0; k < x.slopes.cols(); ++k) {
            if (k == GRIT_SAND_PRESSURE_SHIFT) continue;  // p_t is 0: no way down
            const double size = size_of(sand, k);
            const Numbers reference = size * differences(path, options_with(1e-12), k, 2e-4 * size);
            EXPECT_LE(std::fabs(size * x.slopes(13, k) - reference[13]),
                      1e-2 * std::fabs(reference[13]) + 1e-12)
                << p << " " << k;
        }
    }
}

// It is scaled back to the cone, and its derivatives with it. It goes on from the kink at the edge: differences see 1e-5
// of how steps leave that.
TEST(ParameterDerivatives, FollowAStartOutsideTheCone) {
    const Sand sand = sand_named("lausitz");
    const State start{principal(-100.0, 4.0, 1.0), Vec::Zero(), 0.7};
    const Voigt strain = voigt_strain(1e-4 * principal(-1.0, 0.3, 0.2));
    const grit_sand_options tight = options_with(1e-12);
    Differentiated x(point_of(start), 6);
    x.slopes.topRows<6>().setIdentity();  // by the stress at the start
    const std::vector<int> none(6, GRIT_SAND_NO_PARAMETER);
    const Outcome out = update(sand, x, strain.data(), none, {}, tight);
    ASSERT_EQ(out.status, GRIT_OK) << out.error.message;
    EXPECT_TRUE(out.report.flags & GRIT_SAND_OUTSIDE_CONE);
    for (int k = 0; k < 6; ++k) {
        constexpr double step = 1e-4;
        const auto end = [&](double change) {
            Point point = point_of(start);
            point.stress[k] += change;
            EXPECT_EQ(update(sand, point, strain.data(), tight).status, GRIT_OK);
            return numbers_of(point);
        };
        const Numbers differences = (end(step) - end(-step)) / (2.0 * step);
        EXPECT_LE((x.slopes.col(k) - differences).norm(), 1e-4 * differences.norm()) << k;
    }
}

TEST(ParameterDerivatives, OfAnIncrementThatIsZeroStayAndTakeTheStiffnessAtRest) {
    const Sand sand = sand_named("lausitz");
    Random random(207);
    const State x = random_state(sand, random);
    Differentiated rest(point_of(x), 21);
    rest.slopes.setRandom();
    rest.slopes.row(13).setZero();
    const Slopes start = rest.slopes;
    StrainSlopes unit = StrainSlopes::Zero(6, 21);
    unit.rightCols<6>().setIdentity();
    const Voigt none{};
    update(sand, rest, none.data(), all_directions(), unit, options_with());
    EXPECT_LE((rest.slopes - start).leftCols<15>().norm(), 1e-14);
    Point point = point_of(x);
    const Outcome out =
        update(sand, point, none.data(), options_with(1e-5, GRIT_TANGENT_CONSISTENT));
    const Eigen::Map<const Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> C(out.tangent);
    const Mat change = (rest.slopes - start).topRightCorner<6, 6>();
    EXPECT_LE((change - C).norm(), 1e-12 * C.norm());
    // h follows by all of the strain, e by (H9).
    const Mat of_h = (rest.slopes - start).block<6, 6>(6, 15);
    EXPECT_LE((of_h - Mat::Identity()).norm(), 1e-14);
    Vec of_e = Vec::Zero();
    of_e.head<3>().setConstant(1.0 + x.e);
    EXPECT_LE(((rest.slopes - start).block<1, 6>(12, 15).transpose() - of_e).norm(), 1e-14);
}

struct Refusal {
    Sand sand = sand_named("lausitz");
    Differentiated x{point_of({-100.0 * identity(), Vec::Zero(), 0.7}), 2};
    std::vector<int> parameters = {0, GRIT_SAND_NO_PARAMETER};
    Voigt strain = voigt_strain(1e-4 * principal(-1.0, 0.0, 0.0));
    grit_sand_options options = options_with();

    int evaluations = 0;

    std::string text() {
        const Differentiated before = x;
        const Outcome out = update(sand, x, strain.data(), parameters, {}, options);
        evaluations = out.report.evaluations;
        EXPECT_NE(out.status, GRIT_OK);
        EXPECT_TRUE(same_bits(x.point, before.point));
        EXPECT_EQ(std::memcmp(x.slopes.data(), before.slopes.data(), 28 * sizeof(double)), 0);
        return out.error.message;
    }
};

// A point that cannot be integrated keeps its derivatives, as it keeps its stress and state.
TEST(ParameterDerivatives, StayWhereThePointFails) {
    Random random(211);
    const std::vector<int>& directions = all_directions();
    grit_sand_options few = options_with();
    few.evaluation_limit = 8;
    for (const Sand& each : four_sands())
        for (int i = 0; i < 10; ++i) {
            const StrainPath path = random_path(each, random, 1, 0.05, 0.2);
            Differentiated x(path.start, static_cast<int>(directions.size()));
            x.slopes.setRandom();
            const Differentiated before = x;
            const StrainSlopes none = StrainSlopes::Zero(6, x.slopes.cols());
            const Outcome out =
                update(each, x, voigt_strain(path.increments[0]).data(), directions, none, few);
            EXPECT_EQ(out.status, GRIT_NOT_CONVERGED);
            EXPECT_TRUE(same_bits(x.point, before.point));
            EXPECT_EQ(x.slopes, before.slopes);
        }
}

TEST(ParameterDerivatives, RefuseWhatMakesNoSense) {
    const auto expect = [](const char* part, auto change) {
        Refusal r;
        change(r);
        const std::string said = r.text();
        EXPECT_NE(said.find(part), std::string::npos) << said;
    };
    expect("parameter 1 of the derivatives must be in [0, 14), or -1, got 14",
           [](Refusal& r) { r.parameters[1] = 14; });
    expect("elastic_strain_radius (R), which an update without intergranular strain",
           [](Refusal& r) {
               r.parameters[0] = of_R;
               r.options.intergranular_off = 1;
           });
    expect("count of the derivatives must be in [1, 32], got 0",
           [](Refusal& r) { r.parameters.clear(); });
    expect("tangent must be GRIT_TANGENT_NONE or _CONTINUUM beside derivatives",
           [](Refusal& r) { r.options.tangent = GRIT_TANGENT_CONSISTENT; });
    expect("point 0: derivatives of stress, state and strain increment must be finite",
           [](Refusal& r) { r.x.slopes(2, 1) = NAN; });
    expect("point 0: |strain increment| must be at most", [](Refusal& r) { r.strain[0] = 0.5; });
    expect("point 0: the derivatives of the increment of 0.0001 are not finite",
           [](Refusal& r) { r.x.slopes(2, 1) = 1.7e308, r.x.slopes(1, 1) = 1.7e308; });
    Refusal late;
    late.x.slopes(2, 1) = late.x.slopes(1, 1) = 1.7e308;
    late.text();
    EXPECT_GT(late.evaluations, 1);  // the work that found it
}

TEST(ParameterDerivatives, ReadAndWriteNothingBesideTheirViews) {
    const Sand sand = sand_named("lausitz");
    constexpr int n = 3, count = 2, columns = 4;
    Random random(208);
    std::vector<Point> points;
    for (int i = 0; i < n; ++i) points.push_back(point_of(random_state(sand, random)));
    const Voigt strain = voigt_strain(1e-4 * random.direction());
    // Structure of arrays, and a column in the middle of a wider matrix.
    std::vector<double> stress(6 * columns * n, -7.0), state(8 * columns * n, -7.0);
    const auto at = [&](int r, int k, int i) {
        const std::ptrdiff_t row = std::ptrdiff_t{r} * columns + k + 1;
        return static_cast<std::size_t>(row * n + i);
    };
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < count; ++k) {
            for (int r = 0; r < 6; ++r) stress[at(r, k, i)] = 0.0;
            for (int r = 0; r < 8; ++r) state[at(r, k, i)] = r == 6 && k == 1 ? 1.0 : 0.0;
        }
    const std::vector<int> parameters = {1, GRIT_SAND_NO_PARAMETER};
    std::vector<Differentiated> alone;
    for (const Point& point : points) {
        alone.emplace_back(point, count);
        alone.back().slopes(12, 1) = 1.0;
        update(sand, alone.back(), strain.data(), parameters, {}, options_with());
    }
    grit_sand_points q{};
    q.struct_size = sizeof q;
    q.strain_increment = grit_view_of(strain.data(), 0, 1);
    q.stress = grit_mutable_view_of(points[0].stress, 14, 1);
    q.state = grit_mutable_view_of(points[0].state, 14, 1);
    const ptrdiff_t taken[] = {2, 0};
    q.index = taken;
    grit_sand_derivatives d{};
    d.struct_size = sizeof d;
    d.count = count;
    d.parameters = parameters.data();
    d.stress = grit_mutable_matrix_view_of(stress.data() + n, 1, columns * n, n);
    d.state = grit_mutable_matrix_view_of(state.data() + n, 1, columns * n, n);
    const grit_sand_options options = options_with();
    grit_sand_options checked = options;
    checked.validate_only = 1;
    grit_sand_report reports[2];
    for (grit_sand_report& each : reports) each.status = each.evaluations = -7;
    const std::vector<double> before = stress;
    ASSERT_EQ(grit_sand_update_differentiated(sand, &checked, &d, 2, &q, reports, nullptr),
              GRIT_OK);
    EXPECT_EQ(stress, before);
    for (const grit_sand_report& each : reports) {
        EXPECT_EQ(each.status, GRIT_OK);
        EXPECT_EQ(each.evaluations, 0);
    }
    ASSERT_EQ(grit_sand_update_differentiated(sand, &options, &d, 2, &q, nullptr, nullptr),
              GRIT_OK);
    for (const int i : {0, 2}) {
        for (int k = 0; k < count; ++k) {
            for (int r = 0; r < 6; ++r)
                EXPECT_EQ(stress[at(r, k, i)], alone[static_cast<std::size_t>(i)].slopes(r, k));
            for (int r = 0; r < 8; ++r)
                EXPECT_EQ(state[at(r, k, i)], alone[static_cast<std::size_t>(i)].slopes(6 + r, k));
            EXPECT_EQ(stress[at(0, k, 1)], 0.0);
        }
        EXPECT_EQ(stress[at(0, -1, i)], -7.0);
        EXPECT_EQ(stress[at(5, 2, i)], -7.0);
        EXPECT_EQ(state[at(7, 2, i)], -7.0);
    }
}

}  // namespace
