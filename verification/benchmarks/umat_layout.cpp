// SPDX-License-Identifier: BSD-3-Clause
#include "umat_layout.hpp"

#include <set>
#include <sstream>
#include <stdexcept>

#include <toml++/toml.h>

namespace benchmarks {
namespace {

template <class... Parts> std::string text(const Parts&... parts) {
    std::ostringstream out;
    (out << ... << parts);
    return out.str();
}

class LayoutFile {
  public:
    explicit LayoutFile(const std::string& file) : path(file) {
        try {
            table = toml::parse_file(file);
        } catch (const toml::parse_error& error) {
            fail(text(error.description(), ", line ", error.source().begin.line));
        }
    }

    template <class Value> std::optional<Value> find(const char* key, const char* type) {
        known.insert(key);
        const auto node = table[key];
        const std::optional<Value> value = node.value_exact<Value>();
        if (node && !value) fail(text(key, " must be ", type));
        return value;
    }
    template <class Value> Value get(const char* key, const char* type) {
        const auto value = find<Value>(key, type);
        if (!value) fail(text(key, " is missing"));
        return *value;
    }

    // From 1 in the file, from 0 here; -1 where the key is optional and not there.
    int place(const char* key, int nstatv, int count = 1, bool optional = false) {
        const auto given = find<std::int64_t>(key, "a whole number");
        if (!given && optional) return -1;
        if (!given) fail(text(key, " is missing"));
        return checked(key, *given, nstatv, count);
    }
    int checked(const char* key, std::int64_t given, int nstatv, int count) const {
        const int last = nstatv - count + 1;
        if (given < 1 || given > last)
            fail(text(key, " must be a place in STATEV, 1 to ", last, ", got ", given));
        return static_cast<int>(given) - 1;
    }

    std::vector<double> numbers(const char* key) {
        known.insert(key);
        const toml::array* list = table[key].as_array();
        if (!list || list->empty()) fail(text(key, " must be a list of numbers"));
        return numbers_of(key, *list);
    }
    std::vector<std::pair<int, double>> places_and_values(const char* key, int nstatv) {
        known.insert(key);
        std::vector<std::pair<int, double>> out;
        if (!table[key]) return out;
        const toml::array* list = table[key].as_array();
        if (!list) fail(text(key, " must be a list of [place, value]"));
        for (const toml::node& entry : *list) {
            const toml::array* pair = entry.as_array();
            if (!pair || pair->size() != 2 || !(*pair)[0].is_integer())
                fail(text(key, " must be a list of [place, value]"));
            const std::int64_t place = **(*pair)[0].as_integer();
            out.emplace_back(checked(key, place, nstatv, 1), numbers_of(key, *pair)[1]);
        }
        return out;
    }

    void refuse_unknown() const {
        for (const auto& [key, value] : table)
            if (!known.contains(std::string(key.str()))) fail(text("unknown key ", key.str()));
    }
    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(path + ": " + what);
    }

  private:
    std::vector<double> numbers_of(const char* key, const toml::array& list) const {
        std::vector<double> out;
        for (const toml::node& entry : list) {
            const auto value = entry.is_number() ? entry.value<double>() : std::nullopt;
            if (!value) fail(text(key, " must have numbers only"));
            out.push_back(*value);
        }
        return out;
    }

    std::string path;
    toml::table table;
    std::set<std::string> known;
};

}  // namespace

UmatLayout read_umat_layout(const std::string& path) {
    LayoutFile file(path);
    UmatLayout out;
    out.name = file.get<std::string>("name", "a string");
    if (out.name.empty() || out.name.find('/') != std::string::npos)
        file.fail("name must be words without \"/\", got \"" + out.name + "\"");
    out.props = file.numbers("props");
    const auto nstatv = file.get<std::int64_t>("nstatv", "a whole number");
    if (nstatv < 7 || nstatv > 10000)
        file.fail(text("nstatv must be in [7, 10000]: six of h and e, got ", nstatv));
    out.nstatv = static_cast<int>(nstatv);
    out.void_ratio = file.place("void_ratio", out.nstatv);
    out.intergranular_strain = file.place("intergranular_strain", out.nstatv, 6);
    const int behind = out.void_ratio - out.intergranular_strain;
    if (behind >= 0 && behind < 6)
        file.fail(text("void_ratio must not be one of the six places of intergranular_strain, got ",
                       out.void_ratio + 1));
    out.evaluations = file.place("evaluations", out.nstatv, 1, true);
    const std::string shear =
        file.find<std::string>("intergranular_shear", "a string").value_or("engineering");
    if (shear != "engineering" && shear != "tensor")
        file.fail("intergranular_shear must be \"engineering\" or \"tensor\", got \"" + shear +
                  "\"");
    out.shear = shear == "tensor" ? 0.5 : 1.0;
    out.ddsdde_may_be_null = file.find<bool>("ddsdde_may_be_null", "true or false").value_or(false);
    out.initial_statev = file.places_and_values("initial_statev", out.nstatv);
    file.refuse_unknown();
    return out;
}

}  // namespace benchmarks
