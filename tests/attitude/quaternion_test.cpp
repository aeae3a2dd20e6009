#include "linkwright/attitude/quaternion.hpp"

#include <gtest/gtest.h>
