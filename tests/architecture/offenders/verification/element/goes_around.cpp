// An element test that goes around the ABI.
#include <umat/material.hpp>
