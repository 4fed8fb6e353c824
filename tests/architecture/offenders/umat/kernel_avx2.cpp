// A kernel that reaches a library through a header.
#include "umat/knows_contact.hpp"
