// SPDX-License-Identifier: BSD-3-Clause
// A TOML table read strictly: what is asked for must have its type, what is left is an error. Numbers
// may come from a row of a table of samples: "column p0_kPa".
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cli/toml/case_setting.hpp"

namespace cli {

// A row of a table of samples: its name, and what "column NAME" stands for, by name.
struct SampleRow {
    std::string name;
    std::map<std::string, std::string> cells;
};

class TomlTable {
  public:
    // A file and, if it has one, its base and settings (see toml_document.hpp). inputs: files that were read. Throws
    // BadInput for a file that cannot be read or is no TOML.
    static TomlTable of_file(const std::filesystem::path& path,
                             std::vector<std::filesystem::path>* inputs = nullptr,
                             const std::vector<CaseSetting>& settings = {});

    bool has(const std::string& key);
    double number(const std::string& key);
    std::optional<double> number_if(const std::string& key);
    double positive_or(const std::string& key, double otherwise);
    int integer_or(const std::string& key, int otherwise, int lowest, int highest);
    bool boolean_or(const std::string& key, bool otherwise);
    std::string string(const std::string& key);
    std::optional<std::string> string_if(const std::string& key);
    // A string that must be one of these.
    std::string choice(const std::string& key, const std::vector<std::string>& words);
    // size 0: any.
    std::vector<double> numbers(const std::string& key, std::size_t size = 0);
    std::optional<std::vector<double>> numbers_if(const std::string& key, std::size_t size = 0);
    std::vector<std::string> strings_or_none(const std::string& key);  // a string is a list of one
    TomlTable table(const std::string& key);
    std::optional<TomlTable> table_if(const std::string& key);
    std::vector<TomlTable> tables_if(const std::string& key);  // [[key]]

    // Keys as they are written.
    std::vector<std::string> given() const;
    // Of several ways to say it, exactly one must be there; returns it.
    std::string one_of(const std::vector<std::string>& keys);
    std::optional<std::string> one_of_if(const std::vector<std::string>& keys);

    // Refuse keys nobody has asked for, naming the nearest of those somebody has.
    void finish() const;

    // Refuse a file that is a case of this command, as a table tells which no case of another has.
    void refuse_case_of(const std::string& command) const;

    // Throw BadInput at the line of a key, or of the table if it is missing.
    [[noreturn]] void fail(const std::string& key, const std::string& message) const;
    // "stage[2].axial_strain"
    std::string full(const std::string& key) const;

    // For this table and those taken from it afterwards.
    void take_columns_from(const SampleRow& row) { columns = &row; }
    // A file may write the second name in the place of the first, as errors do then.
    using OtherNames = std::map<std::string, std::string>;
    void take_names_from(const OtherNames& names);
    // Of the file that says this key, or of the case where an option does.
    std::filesystem::path folder_of(const std::string& key) const;
    // All values below, "body.pile.rigid.time_s" and as TOML; of a list of tables "stage" has their names.
    std::map<std::string, std::string> values() const;

  private:
    struct Content;  // hides the TOML library
    TomlTable(std::shared_ptr<const Content> content, std::string path, std::string name,
              const SampleRow* columns);

    void require(const std::string& key);
    void refuse_misspelt(const std::string& key) const;
    // Of a key, or of a place in its list.
    std::optional<double> value_of(const std::string& key, std::ptrdiff_t place = -1) const;
    std::optional<double> column_of(const std::string& key, const std::string& text) const;

    std::shared_ptr<const Content> content;
    std::string path;
    std::string name;
    std::set<std::string> known;
    const SampleRow* columns = nullptr;
};

}  // namespace cli
