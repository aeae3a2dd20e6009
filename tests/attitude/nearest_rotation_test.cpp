#include "linkwright/attitude/nearest_rotation.hpp"

#include <gtest/gtest.h>
