// SPDX-License-Identifier: GPL-2.0-only
// What the installed headers of LAMMPS name of the fmt that it was built with, which is not installed: enough
// to parse them. Messages go through std::string, so that nothing of this is ever called.
#pragma once

namespace fmt {
class string_view;
class format_args;
template <class... Args, class Format>
format_args make_args_checked(const Format& format, const Args&... args);
}  // namespace fmt
