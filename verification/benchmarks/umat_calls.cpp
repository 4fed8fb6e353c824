// SPDX-License-Identifier: BSD-3-Clause
#include "umat_calls.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace benchmarks {

element::UmatFunction open_umat(const std::string& library) {
    // A bare name would be looked up in the folders of the system.
    const std::string path = std::filesystem::absolute(library).string();
    void* handle = dlopen(path.c_str(), RTLD_LAZY | RTLD_LOCAL);
    if (!handle) throw std::runtime_error(dlerror());
    for (const char* name : {"umat_", "UMAT", "umat"})
        if (void* symbol = dlsym(handle, name))
            return reinterpret_cast<element::UmatFunction>(symbol);
    throw std::runtime_error(path + " has no symbol umat_, UMAT or umat");
}

UmatPoints::UmatPoints(const std::vector<Call>& calls, const UmatLayout& layout)
    : ddsdde(36 * calls.size()), pnewdt(calls.size(), 1.0) {
    const auto n = static_cast<std::size_t>(layout.nstatv);
    statev.assign(n * calls.size(), 0.0);
    double* state = statev.data();
    for (const Call& c : calls) {
        dstran.insert(dstran.end(), c.strain, c.strain + 6);
        stress.insert(stress.end(), c.stress, c.stress + 6);
        for (const auto& [place, value] : layout.initial_statev) state[place] = value;
        for (int i = 0; i < 6; ++i)
            state[layout.intergranular_strain + i] = (i < 3 ? 1.0 : layout.shear) * c.state[i];
        state[layout.void_ratio] = c.state[GRIT_SAND_VOID_RATIO];
        state += n;
    }
}

void run_umat(element::UmatFunction umat, UmatLayout& layout, bool tangent, UmatPoints& points) {
    double energy[3] = {}, rpl = 0.0, ddsddt[6] = {}, drplde[6] = {}, drpldt = 0.0, stran[6] = {};
    double time[2] = {1.0, 1.0}, dtime = 1.0, temp = 0.0, dtemp = 0.0, predef[1] = {},
           dpred[1] = {};
    double coords[3] = {}, celent = 1.0;
    double identity[3][9];
    for (auto& matrix : identity)
        for (int i = 0; i < 9; ++i) matrix[i] = i % 4 == 0 ? 1.0 : 0.0;
    char cmname[81] = "SAND";
    std::fill(cmname + 4, cmname + 80, ' ');
    int ndi = 3, nshr = 3, ntens = 6, nstatv = layout.nstatv;
    int nprops = static_cast<int>(layout.props.size());
    int noel = 1, npt = 1, layer = 1, kspt = 1, kstep = 1, kinc = 2;
    for (std::size_t i = 0; i < points.size(); ++i)
        umat(&points.stress[6 * i], &points.statev[static_cast<std::size_t>(nstatv) * i],
             tangent ? &points.ddsdde[36 * i] : nullptr, &energy[0], &energy[1], &energy[2], &rpl,
             ddsddt, drplde, &drpldt, stran, &points.dstran[6 * i], time, &dtime, &temp, &dtemp,
             predef, dpred, cmname, &ndi, &nshr, &ntens, &nstatv, layout.props.data(), &nprops,
             coords, identity[0], &points.pnewdt[i], &celent, identity[1], identity[2], &noel, &npt,
             &layer, &kspt, &kstep, &kinc, 80);
}

std::vector<Outcome> outcomes_of(const std::vector<Call>& calls, const UmatLayout& layout,
                                 const UmatPoints& points) {
    std::vector<Outcome> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double* stress = &points.stress[6 * i];
        const double* state = &points.statev[static_cast<std::size_t>(layout.nstatv) * i];
        const bool finite =
            std::all_of(stress, stress + 6, [](double s) { return std::isfinite(s); });
        const bool moved = !std::equal(stress, stress + 6, calls[i].stress);
        out.push_back({!finite || !moved || !(points.pnewdt[i] >= 1.0),
                       stress_error(calls[i], stress),
                       layout.evaluations < 0 ? std::numeric_limits<double>::quiet_NaN()
                                              : state[layout.evaluations]});
    }
    return out;
}

}  // namespace benchmarks
