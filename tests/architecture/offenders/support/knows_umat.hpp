// What all share knows one of them.
#include "umat/model/material.hpp"
