// SPDX-License-Identifier: BSD-3-Clause
// Particle clouds around nodes, and how a host would ask for their normals.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>
#include <grit/contact_normals.h>
#include <gtest/gtest.h>

namespace tests {

using Vec3 = Eigen::Vector3d;

constexpr int A = GRIT_CONTACT_BODY_A, B = GRIT_CONTACT_BODY_B;

// The same numbers on every machine.
class Dice {
  public:
    explicit Dice(std::uint64_t seed) : engine(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
    }
    int below(int n) { return static_cast<int>(uniform(0.0, n)); }
    double log_uniform(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    // In a ball, with zeros behind the components.
    Vec3 inside_ball(int components) {
        for (;;) {
            Vec3 x = Vec3::Zero();
            for (int c = 0; c < components; ++c) x[c] = uniform(-1.0, 1.0);
            if (x.norm() < 1.0) return x;
        }
    }
    Vec3 direction(int components) {
        for (;;) {
            const Vec3 x = inside_ball(components);
            if (x.norm() > 0.1) return x.normalized();
        }
    }
    Eigen::Matrix3d rotation(int components) {
        const Vec3 axis = components == 3 ? direction(3) : Vec3::UnitZ();
        return Eigen::AngleAxisd(uniform(-3.0, 3.0), axis).toRotationMatrix();
    }

  private:
    std::mt19937_64 engine;
};

struct Particle {
    Vec3 x;
    int body;
    double weight = 1.0;
};

using Cloud = std::vector<Particle>;

// The clouds of several nodes in a host's arrays.
struct Clouds {
    int components;
    std::vector<double> position, weight, normal;
    std::vector<int> body, fixed;
    std::vector<std::ptrdiff_t> offset{0};
    std::vector<grit_status> status;
    std::vector<char> workspace;
    grit_contact_normal_counts counts{sizeof(grit_contact_normal_counts), 0, 0, 0};
    grit_error error{};

    explicit Clouds(int c, const std::vector<Cloud>& nodes) : components(c) {
        std::size_t most = 0;
        for (const Cloud& cloud : nodes) {
            for (const Particle& p : cloud) {
                position.insert(position.end(), p.x.data(), p.x.data() + c);
                body.push_back(p.body);
                weight.push_back(p.weight);
            }
            offset.push_back(static_cast<std::ptrdiff_t>(body.size()));
            most = std::max(most, cloud.size());
        }
        fixed.assign(nodes.size(), 0);
        normal.assign(nodes.size() * static_cast<std::size_t>(c), 7.0);
        status.assign(nodes.size(), -1);
        workspace.assign(
            grit_contact_regression_workspace_size(static_cast<std::ptrdiff_t>(most), c),
            '\xff');  // whoever reads what he has not written reads NaN
    }
    std::ptrdiff_t nodes() const { return static_cast<std::ptrdiff_t>(fixed.size()); }
    grit_contact_clouds views() {
        grit_contact_clouds q{};
        q.struct_size = sizeof q;
        q.components = components;
        q.offset = offset.data();
        q.particles = static_cast<std::ptrdiff_t>(body.size());
        q.position = grit_view_of(position.data(), components, 1);
        q.body = body.data();
        q.weight = grit_view_of(weight.data(), 1, 1);
        q.length = 1.0;
        q.fixed = fixed.data();
        q.status = status.data();
        q.normal = grit_mutable_view_of(normal.data(), components, 1);
        return q;
    }
    grit_status regress(const grit_contact_clouds& q) {
        return grit_contact_normals_by_regression(nodes(), &q, workspace.data(), workspace.size(),
                                                  &counts, &error);
    }
    Vec3 normal_at(std::size_t i) const {
        Vec3 n = Vec3::Zero();
        for (int c = 0; c < components; ++c)
            n[c] = normal[i * static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
        return n;
    }
};

// The normal of one node by a call of its own.
inline Vec3 regressed(int components, const Cloud& cloud, double ridge = 0.0, double length = 1.0,
                      int fixed = 0, int instruction_set = 0) {
    Clouds x(components, {cloud});
    grit_contact_clouds q = x.views();
    q.ridge = ridge;
    q.length = length;
    q.instruction_set = instruction_set;
    x.fixed[0] = fixed;
    EXPECT_EQ(x.regress(q), GRIT_OK) << x.error.message;
    return x.normal_at(0);
}

// Particles on both sides of a plane; overlap is the depth to which they reach beyond it.
inline Cloud parted_cloud(int components, int count, double overlap, Dice& dice) {
    const Vec3 n = dice.direction(components);
    Cloud cloud;
    for (int p = 0; p < count; ++p) {
        const Vec3 x = dice.inside_ball(components);
        const double along = x.dot(n) + overlap * dice.uniform(-1.0, 1.0);
        cloud.push_back({x, p == 0 ? A : p == 1 || along > 0.0 ? B : A});
    }
    return cloud;
}

inline bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0;
}

}  // namespace tests
