// A constitutive law that knows the contact, and a library of others.
#include <Eigen/Dense>

#include "contact/normals.hpp"
