// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/run.hpp"

#include <memory>
#include <system_error>

#include "element/errors.hpp"
#include "element/incremental_driver/classic_law.hpp"
#include "element/incremental_driver/initial_conditions.hpp"
#include "element/incremental_driver/output_file.hpp"
#include "element/incremental_driver/test_file.hpp"
#include "element/library_law.hpp"
#include "element/output_lock.hpp"
#include "element/simulate.hpp"
#include "element/text.hpp"

namespace incremental_driver {
namespace {

using element::text;

struct Inputs {
    std::filesystem::path parameters_path, initial_path, test_path;
    Parameters parameters;
    InitialConditions initial;
};

std::shared_ptr<const element::Law> own_law(const Inputs& in, const element::MaterialPoint& start) {
    const int nstatv = static_cast<int>(in.initial.statev.size());
    ClassicSand sand = read_classic_props(in.parameters, in.parameters_path);
    const auto refuse = [&](const std::string& why) -> BadInput {
        return BadInput(text("%s:%d: %s", in.initial_path.string().c_str(), in.initial.nstatv_line,
                             why.c_str()));
    };
    if (nstatv < GRIT_CLASSIC_NSTATV)
        throw refuse(text("nstatv must be at least %d in the classic layout, better %d, got %d",
                          GRIT_CLASSIC_NSTATV, GRIT_CLASSIC_NSTATV + 1, nstatv));
    auto law = std::make_shared<ClassicLaw>(std::move(sand), nstatv);
    try {
        law->check(start);
    } catch (const element::BadCase& error) {
        throw refuse(text("the sand cannot start from this state: %s", error.what()));
    }
    return law;
}

std::shared_ptr<const element::Law> foreign_law(const Inputs& in,
                                                const std::filesystem::path& library) {
    element::UmatSource source;
    source.library = library;
    source.props = in.parameters.props;
    source.state_size = static_cast<int>(in.initial.statev.size());
    source.material_name = in.parameters.name;
    try {
        return element::open_library_law(source);
    } catch (const element::BadCase& error) {
        throw BadInput(error.what());
    }
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code refused;
    if (!folder.empty()) std::filesystem::create_directories(folder, refused);
    if (refused)
        throw BadInput(text("%s: cannot make this folder: %s", folder.string().c_str(),
                            refused.message().c_str()));
}

// Refuse to overwrite what has been read, by whatever name it goes.
void check_output(const std::filesystem::path& output, const Inputs& in, const Test& test) {
    std::vector<std::filesystem::path> read = test.inputs;
    read.insert(read.end(), {in.parameters_path, in.initial_path, in.test_path});
    std::error_code unknown;
    for (const std::filesystem::path& input : read)
        if (std::filesystem::equivalent(output, input, unknown))
            throw BadInput(text("%s:%d: the output would overwrite %s",
                                in.test_path.string().c_str(), test.output_line,
                                input.string().c_str()));
    if (std::filesystem::is_directory(output))
        throw BadInput(text("%s:%d: the output %s is a folder", in.test_path.string().c_str(),
                            test.output_line, output.string().c_str()));
}

Report simulate(const Request& request, const Inputs& in, const element::Law& law, const Test& test,
                element::Sample sample, const element::Listeners& listeners) {
    Report report;
    report.output = (request.out.empty() ? request.folder : request.out) / test.output;
    const int nstatv = static_cast<int>(in.initial.statev.size());
    check_output(report.output, in, test);
    make_folder(report.output.parent_path());
    const element::OutputLock lock({report.output});
    OutputFile file(report.output, test.heading, nstatv);
    element::Listeners ours;
    ours.record = [&](const element::Record& record) {
        file.row(record);
        if (listeners.record) listeners.record(record);
    };
    ours.increment = [&](const element::Progress& progress) {
        report.increments = progress.increment;
        return !listeners.increment || listeners.increment(progress);
    };
    const element::History history = element::simulate(law, sample, test.program, {}, ours);
    file.complete();
    report.rows = file.rows();
    report.exits = history.exits;
    if (history.failure) {
        const StepNote& note = test.notes[static_cast<std::size_t>(history.failure->step) - 1];
        report.failure = text("%s:%d: %s", in.test_path.string().c_str(), note.line,
                              history.failure->message.c_str());
    }
    return report;
}

}  // namespace

Report run(const Request& request, const element::Listeners& listeners) {
    Inputs in;
    in.parameters_path = request.folder / "parameters.inp";
    in.initial_path = request.folder / "initialconditions.inp";
    in.test_path = request.folder / "test.inp";
    in.parameters = read_parameters(in.parameters_path);
    in.initial = read_initial_conditions(in.initial_path);
    element::Sample sample;
    sample.point = {in.initial.stress, in.initial.statev};
    sample.temperature = in.initial.temperature;
    const auto law =
        request.umat.empty() ? own_law(in, sample.point) : foreign_law(in, request.umat);
    const Test test = read_test(in.test_path, law->state_names());
    return simulate(request, in, *law, test, std::move(sample), listeners);
}

}  // namespace incremental_driver
