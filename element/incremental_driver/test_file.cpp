// SPDX-License-Identifier: BSD-3-Clause
#include "element/incremental_driver/test_file.hpp"

#include <algorithm>

#include "element/schedule.hpp"

namespace incremental_driver {
namespace {

constexpr int most_steps = 1000;              // of one *Repetition
constexpr std::size_t most_notes = 10000000;  // steps, repetitions counted through

class TestFileReader {
  public:
    TestFileReader(const std::filesystem::path& path, const std::vector<std::string>& state_names)
        : lines(path), context{path.parent_path(),
                               element::incremental_driver_words(state_names),
                               {}} {}

    Test read() {
        read_first_line();
        bool ended = false;
        while (!ended && !lines.at_end()) {
            const Keyword keyword = read_keyword(lines, lines.next("a step"));
            if (keyword.name == "*End") ended = true;
            else if (keyword.name == "*Repetition") read_repetition(keyword);
            else test.program.push_back(read_one(keyword, test.notes));
        }
        test.inputs = context.inputs;
        if (test.program.empty()) lines.fail(test.output_line, "there is no step behind this line");
        return test;
    }

  private:
    void read_first_line() {
        const Line& line = lines.next("the name of the output file");
        test.output_line = line.number;
        const std::size_t mark = line.text.find('#');
        test.output = trimmed(line.text.substr(0, mark));
        if (mark != std::string::npos) test.heading = trimmed(line.text.substr(mark + 1));
        const std::string got = ", got \"" + trimmed(line.text) + "\"";
        if (test.output.empty() || test.output.starts_with('*') || test.output.ends_with('/'))
            lines.fail(line.number, "expected the name of the output file" + got);
        const std::filesystem::path output = test.output;
        if (output.is_absolute() || std::find(output.begin(), output.end(), "..") != output.end())
            lines.fail(line.number,
                       "the output file lies in the folder of the output (--out), not elsewhere" +
                           got);
    }

    element::Step read_one(const Keyword& keyword, std::vector<StepNote>& notes) {
        element::Step step = read_step(lines, keyword, context);
        notes.push_back({keyword.line, keyword.name});
        if (auto* walk = std::get_if<element::RandomWalk>(&step.kind))
            walk->seed = static_cast<std::uint64_t>(keyword.line);  // another walk in each step
        return step;
    }

    void read_repetition(const Keyword& keyword) {
        Fields fields(lines, lines.next("nSteps nRep of *Repetition"));
        const int steps = fields.whole("nSteps", 1, most_steps);
        element::Repetition repetition;
        repetition.times = fields.whole("nRep", 1, element::increment_limit);
        std::vector<StepNote> notes;
        for (int i = 0; i < steps; ++i) {
            const Line& line = lines.next("a step of *Repetition");
            const Keyword inner = read_keyword(lines, line);
            if (inner.name == "*Repetition" || inner.name == "*End")
                lines.fail(line.number, "expected step " + std::to_string(i + 1) + " of the " +
                                            std::to_string(steps) + " of *Repetition, got " +
                                            inner.name);
            repetition.steps.push_back(read_one(inner, notes));
        }
        if (notes.size() * static_cast<std::size_t>(repetition.times) > most_notes)
            lines.fail(keyword.line, "more than 10000000 steps");
        for (int i = 0; i < repetition.times; ++i)
            test.notes.insert(test.notes.end(), notes.begin(), notes.end());
        element::Step step;
        step.name = keyword.name;
        step.kind = std::move(repetition);
        test.program.push_back(std::move(step));
    }

    Lines lines;
    StepContext context;
    Test test;
};

}  // namespace

Test read_test(const std::filesystem::path& path, const std::vector<std::string>& state_names) {
    return TestFileReader(path, state_names).read();
}

}  // namespace incremental_driver
