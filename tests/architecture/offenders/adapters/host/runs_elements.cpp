// SPDX-License-Identifier: BSD-3-Clause
#include "element/law.hpp"
