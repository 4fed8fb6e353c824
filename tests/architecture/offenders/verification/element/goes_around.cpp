// An element test that goes around the ABI.
#include <umat/model/material.hpp>
