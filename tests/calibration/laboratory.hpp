// SPDX-License-Identifier: BSD-3-Clause
// Sheets and cases for the program.
#pragma once

#include "support/workplace.hpp"

// An oedometer test as a laboratory keeps it, made from a compression curve; row 2 is its first.
inline std::string oedometer_sheet() {
    return "sigma [kPa],e,remark\n"
           "20,0.7480,\n40,0.7440,\n60,0.7411,\n80,0.7388,\n100,0.7368,\n150,0.7327,\n"
           "200,0.7294,\n300,0.7241,\n400,0.7198,unloaded\n";
}

inline const std::string oedometer_columns =
    "stress_11 = { column = \"sigma [kPa]\", compression = \"positive\" }\n"
    "void_ratio = { column = \"e\", error = 0.001 }\n";

// A case with one oedometer test; more: keys of the test.
inline std::string oedometer_case(const std::string& columns = oedometer_columns,
                                  const std::string& more = "") {
    return "[sand]\nname = \"lausitz\"\n[fit]\nparameters = [\"h_s\", \"n\"]\nstarts = 2\n"
           "[[test]]\nname = \"oedometer\"\ntest = \"oedometer\"\nfile = \"lab.csv\"\n" +
           more + "[test.columns]\n" + columns;
}

// grit calibrate on these.
inline Answer calibrate(const Workplace& here, const std::string& text, const std::string& sheet,
                        const std::string& options = "") {
    here.write("lab.csv", sheet);
    here.write("x.toml", text);
    return here.grit("calibrate x.toml --out out " + options);
}
