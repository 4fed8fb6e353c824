// What all share knows one of them.
#include "umat/material.hpp"
