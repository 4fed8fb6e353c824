// A host that looks inside.
#include "umat/model/material.hpp"
