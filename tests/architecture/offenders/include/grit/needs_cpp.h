// A header of the product that needs C++.
#include <vector>
