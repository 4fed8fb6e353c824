// A host that looks inside.
#include "umat/material.hpp"
