// A program that depends on a host.
#include "adapters/host/entry.hpp"
